#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/methods/floor/diagnostics.hpp"
#include "agents/methods/floor/floor.hpp"
#include "agents/methods/floor/plane_bounds.hpp"
#include "agents/methods/plane_relating.hpp"
#include "agents/perception/homography.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/overlap.hpp"
#include "agents/perception/plane/agreement.hpp"
#include "agents/perception/plane/consensus.hpp"
#include "agents/perception/plane/feature_pairs.hpp"
#include "agents/perception/plane/geometry.hpp"
#include "agents/perception/plane/guided_match.hpp"
#include "agents/perception/plane/level_points.hpp"
#include "agents/perception/plane/repetition.hpp"

namespace weft::agents {
namespace {

/// Returns the fit's covariance, and where the cameras differ adds that of the mounts' position and heading, which no
/// view of a plane shows: of this robot's camera as it is known, of the other one, whose calibration's sigmas its
/// content does not say, as calibrations usually are.
Eigen::Matrix3d covariance_of(const FloorConfig& c, const FloorContent& a, const FloorContent& b,
                              const PlanarFit& fit) {
  Eigen::Matrix3d covariance = fit.covariance.topLeftCorner<3, 3>();
  const bool one_camera = a.camera.id == b.camera.id && a.camera.fx == b.camera.fx;
  const auto variances = [](const FloorConfig& known) {
    const double heading = known.measured_heading_rad > 0.0 ? known.measured_heading_rad : known.mount_yaw_rad;
    const double lever = known.mount_position_m * known.mount_position_m;
    const double focus = known.mount_tilt_rad * known.mount_tilt_rad;
    return Eigen::Vector3d(2.0 * lever, 2.0 * lever, heading * heading + focus);
  };
  Eigen::Vector3d of_mounts = Eigen::Vector3d::Constant(1e-6);
  if (!one_camera) of_mounts += variances(c) + variances(FloorConfig{});
  covariance += of_mounts.asDiagonal();
  return 0.5 * (covariance + covariance.transpose());
}

/// Returns how much higher above its calibration b's camera stood than a's above its own: the two views' scales
/// against each other, as the features alone have them, since the prior holds both cameras at the height of their
/// calibration. None when the features tell it worse than 2 mm.
std::optional<Diagnostic> height_offset_of(const AttitudePrior& prior, const PlanarFit& fit) {
  constexpr double worst_sigma_m = 0.002;
  const double before = 1.0 / prior.information(2, 2) + 1.0 / prior.information(5, 5);
  const Matrix9d& c = fit.covariance;  // heights of a and b stand at 5 and 8
  const double after = c(5, 5) + c(8, 8) - 2.0 * c(5, 8);
  if (after >= before) return std::nullopt;
  const double features = 1.0 / (1.0 / after - 1.0 / before);
  if (features > worst_sigma_m * worst_sigma_m) return std::nullopt;
  const double expected = prior.mean(5) - prior.mean(2);
  const double seen = fit.state.attitude_b.height_m - fit.state.attitude_a.height_m;
  return Diagnostic{std::string(kHeightOffset), features * (seen / after - expected / before), std::sqrt(features),
                    kHeightNoticedM};
}

}  // namespace

OrRefusal<Related> Floor::relate(const Content& a, const Content& b, const std::optional<Relation>& guess) const {
  const FloorConfig& c = config_;
  const std::optional<MatchGate> gate = gate_about(c, guess);
  const SeenPlane floor_a{footprint(a.camera, a.attitude, c.far_m), camera_from_floor(a.camera, a.attitude)};
  const SeenPlane floor_b{footprint(b.camera, b.attitude, c.far_m), camera_from_floor(b.camera, b.attitude)};
  if (gate) {
    const double hoped = share_of_b_seen_in_a(floor_a, floor_b, gate->a_from_b);
    if (hoped < 0.3 * c.kappa) return refuse("no_overlap", hoped, 0.3 * c.kappa);
  }
  const std::vector<Eigen::Vector2d> at_a = level_points(a.camera, a.attitude, a.features);
  const std::vector<Eigen::Vector2d> at_b = level_points(b.camera, b.attitude, b.features);
  const std::vector<Match> matches =
      gate ? guided_matches({a.features, at_a}, {b.features, at_b}, *gate, {c.most_bits, c.ratio}, c.consensus_m)
           : match_descriptors(descriptors_of(a.features), descriptors_of(b.features),
                               {c.most_bits, c.ratio_unguided});
  if (matches.size() < static_cast<std::size_t>(c.fewest_matches))
    return refuse("few_matches", matches.size(), c.fewest_matches);

  const Consensus consensus = find_consensus(consensus_bounds(c), matches, at_a, at_b);
  const auto fewest = static_cast<std::size_t>(c.fewest_inliers);
  if (consensus.count < fewest) return refuse("no_consensus", consensus.count, fewest);
  std::vector<std::size_t> agreeing;
  for (std::size_t i = 0; i < matches.size(); ++i)
    if ((consensus.a_from_b * at_b[matches[i].b] - at_a[matches[i].a]).norm() < c.consensus_m) agreeing.push_back(i);
  const RefinedMotion refined = refine_motion(
      {a.camera, b.camera}, feature_pairs({a.camera, a.features}, {b.camera, b.features}, matches, c.feature_sigma_m),
      agreeing, attitude_prior(a, b), {consensus.a_from_b, a.attitude, b.attitude}, c.inlier_sigmas);

  const std::size_t inliers = refined.pairs.size();
  if (inliers < fewest) return refuse("few_inliers", inliers, fewest);
  const double share = static_cast<double>(inliers) / static_cast<double>(matches.size());
  if (share < c.fewest_inliers_share) return refuse("few_inliers_share", share, c.fewest_inliers_share);
  const PlanarState& state = refined.fit.state;
  const Eigen::Vector3d attitude = (state.attitude_a.vector() - state.attitude_b.vector()).cwiseAbs();
  if (!refined.fit.converged || attitude.head<2>().maxCoeff() > c.most_tilt_rad)
    return refuse("not_rigid", attitude.head<2>().maxCoeff(), c.most_tilt_rad);
  if (attitude.z() > c.most_height_offset_m) return refuse("not_rigid", attitude.z(), c.most_height_offset_m);
  const double overlap = share_of_b_seen_in_a(floor_a, floor_b, state.a_from_b);
  if (overlap < c.kappa) return refuse("little_overlap", overlap, c.kappa);
  if (!gate) {
    const double spread = spread_of_agreement(matches, state.a_from_b, at_a, at_b, floor_a.footprint, c.consensus_m);
    if (spread < c.least_spread) return refuse("little_spread", spread, c.least_spread);
  }
  double residual = 0.0;
  for (const double error : refined.residual_px) residual += huber_distance(error, c.eta_px);
  residual /= static_cast<double>(inliers);
  if (residual > c.most_residual) return refuse("large_residual", residual, c.most_residual);
  if (gate) {
    if (const auto wrong = beyond_gate(*gate, state.a_from_b)) return tl::unexpected(*wrong);
  }
  // A guess keeps apart what lies farther than any guess may be off; nearer, it would have to be believed blindly.
  const double reach_m = gate ? std::max(c.widest_gate_m, 2.0 * gate->distance_m) : kAnywhereM;
  const double most_repeated = c.most_repeated * static_cast<double>(inliers);
  const Repetition again =
      find_repetition(repetition_bounds(c), a.features, at_a, shared_stretch(at_a, floor_b.footprint, state.a_from_b),
                      reach_m, static_cast<std::size_t>(most_repeated) + 1);
  const double repeated = static_cast<double>(again.agreeing) / static_cast<double>(inliers);
  if (repeated > c.most_repeated && again.spread > c.least_spread)
    return refuse("ambiguous", repeated, c.most_repeated);
  Related related{Metric2{state.a_from_b, covariance_of(c, a, b, refined.fit)},
                  static_cast<std::uint32_t>(inliers),
                  overlap,
                  residual,
                  {}};
  if (auto height = height_offset_of(attitude_prior(a, b), refined.fit))
    related.diagnostics.push_back(std::move(*height));
  return related;
}

}  // namespace weft::agents
