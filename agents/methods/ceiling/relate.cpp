#include <algorithm>
#include <cmath>
#include <numeric>

#include "agents/methods/ceiling/ceiling.hpp"
#include "agents/methods/ceiling/rectified.hpp"
#include "agents/methods/ceiling/same_scale.hpp"
#include "agents/methods/plane_relating.hpp"
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

/// Holds one content as it is compared: its features in the level frame, and the ceiling that it shows.
struct Shown {
  Shown(const CeilingConfig& c, const CeilingContent& content)
      : reach_m(c.reach_heights * (content.ceiling_m - content.camera.robot_from_camera.translation.z())),
        at(level_points(content.camera, content.attitude, content.features)),
        plane{footprint(content.camera, content.attitude, reach_m, content.ceiling_m),
              camera_from_plane(content.camera, content.attitude, content.ceiling_m)} {}
  double reach_m;
  std::vector<Eigen::Vector2d> at;
  SeenPlane plane;
};

std::vector<Match> matches_of(const CeilingConfig& c, const CeilingContent& a, const Shown& shown_a,
                              const CeilingContent& b, const Shown& shown_b, const std::optional<MatchGate>& gate,
                              double within_m) {
  if (gate)
    return guided_matches({a.features, shown_a.at}, {b.features, shown_b.at}, *gate, {c.most_bits, c.ratio},
                          within_m);
  return match_descriptors(descriptors_of(a.features), descriptors_of(b.features), {c.most_bits, c.ratio_unguided});
}

/// Returns the fit's covariance, what the ceiling's height leaves of the scale, and where the cameras differ that of
/// the mounts' place, heading and tilt, which puts the point above a robot aside.
Eigen::Matrix3d covariance_of(const CeilingConfig& c, const CeilingContent& a, const CeilingContent& b,
                              const SharedCeiling& ceiling, const PlanarFit& fit) {
  const double away_m = ceiling.ceiling_m - a.camera.robot_from_camera.translation.z();
  Eigen::Matrix3d covariance = fit.covariance.topLeftCorner<3, 3>();
  const double scale = std::hypot(ceiling.sigma_m / away_m, c.focal_share);
  const Eigen::Vector2d way =
      Eigen::Rotation2Dd(-fit.state.a_from_b.heading) * Eigen::Vector2d(fit.state.a_from_b.translation());
  covariance.topLeftCorner<2, 2>() += scale * scale * way * way.transpose();
  // The point above a robot is wrong alike for both where one camera saw both, but turns with the robot.
  const bool one_camera = a.camera.id == b.camera.id && a.camera.fx == b.camera.fx;
  const double turned = 2.0 * std::abs(std::sin(0.5 * fit.state.a_from_b.heading));
  const CeilingConfig usual;
  const auto place_of = [&](const CeilingConfig& known) {
    return std::hypot(known.mount_position_m, std::hypot(0.3 * known.mount_tilt_rad, kHangingTiltRad) * away_m);
  };
  const double own = place_of(c) * turned;
  const double place = one_camera ? own : std::hypot(place_of(c), place_of(usual));
  const double heading = one_camera ? 0.0 : std::hypot(c.mount_yaw_rad, usual.mount_yaw_rad);
  covariance.diagonal() += Eigen::Vector3d(1e-6 + place * place, 1e-6 + place * place, 1e-6 + heading * heading);
  return 0.5 * (covariance + covariance.transpose());
}

/// Tells how well what both see fits elsewhere in a, against how well it fits here: the share of the features that
/// lie where a sees that meet their like. A grid of lamps fits as well a lamp further on, of which less is in view.
double repeated_share(const CeilingConfig& c, const CeilingContent& a, const Shown& shown_a,
                      const std::vector<std::uint32_t>& stretch, double reach_m, std::size_t inliers,
                      double within_m) {
  constexpr std::size_t fewest = 6;  // like features elsewhere are a coincidence of fewer
  constexpr double least_m = 0.3;    // shorter motions the consensus itself does not tell apart
  const Repetition again = find_repetition(
      {.consensus = {.within_m = within_m, .hypotheses = c.hypotheses}, .most_bits = c.most_bits, .least_m = least_m},
      a.features, shown_a.at, stretch, reach_m, fewest);
  if (again.agreeing < fewest) return 0.0;
  const auto lands = static_cast<double>(std::count_if(stretch.begin(), stretch.end(), [&](std::uint32_t i) {
    return contains(shown_a.plane.footprint, again.moved * shown_a.at[i]);
  }));
  const double here = static_cast<double>(inliers) / std::max(1.0, static_cast<double>(stretch.size()));
  const double there = static_cast<double>(again.agreeing) / std::max(lands, static_cast<double>(fewest));
  return there / std::max(here, 1e-9);
}

/// Returns why a and b could not be matched without a guess: `otherwise`, or, where in both most corners have a
/// twin as lamps of a grid have, ambiguous. Such corners fail the test against the second best, so that hardly any is
/// matched, and those by chance.
Refusal why_unmatched(const CeilingContent& a, const Shown& shown_a, const CeilingContent& b, const Shown& shown_b,
                      const Refusal& otherwise) {
  constexpr int twin_bits = 50;       // as few differ hardly ever by chance
  constexpr double least_m = 0.3;     // nearer ones are of one thing
  constexpr double most_twins = 0.7;  // below a lamp grid so many or more have one, of a sheet's ribs about half
  const double in_a = share_with_twins(a.features, shown_a.at, twin_bits, least_m);
  if (in_a <= most_twins) return otherwise;
  const double in_both = std::min(in_a, share_with_twins(b.features, shown_b.at, twin_bits, least_m));
  return in_both > most_twins ? Refusal{"ambiguous", in_both, most_twins} : otherwise;
}

/// Returns why a motion is not to be believed; nothing: it is.
std::optional<Refusal> implausible(const CeilingConfig& c, const RefinedMotion& refined, std::size_t matches) {
  const std::size_t inliers = refined.pairs.size();
  const auto refusal = [](std::string_view reason, double measured, double bound) {
    return Refusal{reason, measured, bound};
  };
  if (inliers < static_cast<std::size_t>(c.fewest_inliers))
    return refusal("few_inliers", static_cast<double>(inliers), c.fewest_inliers);
  const double share = static_cast<double>(inliers) / static_cast<double>(matches);
  if (share < c.fewest_inliers_share) return refusal("few_inliers_share", share, c.fewest_inliers_share);
  const PlanarState& state = refined.fit.state;
  const Eigen::Vector3d apart = (state.attitude_a.vector() - state.attitude_b.vector()).cwiseAbs();
  const double tilted = apart.head<2>().maxCoeff();
  if (!refined.fit.converged || tilted > c.most_tilt_rad) return refusal("not_rigid", tilted, c.most_tilt_rad);
  const double residual =
      std::accumulate(refined.residual_px.begin(), refined.residual_px.end(), 0.0) / static_cast<double>(inliers);
  if (residual > c.most_residual_px) return refusal("large_residual", residual, c.most_residual_px);
  return std::nullopt;
}

}  // namespace

OrRefusal<Related> Ceiling::relate(const Content& first, const Content& second,
                                   const std::optional<Relation>& guess) const {
  const CeilingConfig& c = config_;
  const SharedCeiling ceiling = shared_ceiling(first, second);
  if (ceiling.apart_sigmas > c.most_scale_sigmas)
    return refuse("other_ceiling", ceiling.apart_sigmas, c.most_scale_sigmas);
  const CeilingContent a = at_ceiling(first, ceiling.ceiling_m);
  const CeilingContent b = at_ceiling(second, ceiling.ceiling_m);
  const Shown shown_a(c, a);
  const Shown shown_b(c, b);
  const std::optional<MatchGate> gate = gate_about(c, guess);
  if (gate) {
    const double hoped = share_of_b_seen_in_a(shown_a.plane, shown_b.plane, gate->a_from_b);
    if (hoped < 0.3 * c.kappa) return refuse("no_overlap", hoped, 0.3 * c.kappa);
  }
  const double pixel_m = metres_per_pixel(c, ceiling.ceiling_m);
  const double within_m = c.consensus_px * pixel_m;
  const std::vector<Match> matches = matches_of(c, a, shown_a, b, shown_b, gate, within_m);
  const auto unmatched = [&](std::string_view reason, std::size_t measured, int bound) {
    const Refusal refusal{reason, static_cast<double>(measured), static_cast<double>(bound)};
    return tl::unexpected(gate ? refusal : why_unmatched(a, shown_a, b, shown_b, refusal));
  };
  if (matches.size() < static_cast<std::size_t>(c.fewest_matches))
    return unmatched("few_matches", matches.size(), c.fewest_matches);
  const Consensus consensus = find_consensus({.within_m = within_m,
                                              .hypotheses = c.hypotheses,
                                              .shortest_base_m = 0.1 * shown_a.reach_m,
                                              .score = ConsensusScore::truncated},
                                             matches, shown_a.at, shown_b.at);
  if (consensus.count < static_cast<std::size_t>(c.fewest_inliers))
    return unmatched("no_consensus", consensus.count, c.fewest_inliers);
  std::vector<std::size_t> agreeing;
  for (std::size_t i = 0; i < matches.size(); ++i)
    if ((consensus.a_from_b * shown_b.at[matches[i].b] - shown_a.at[matches[i].a]).norm() < within_m)
      agreeing.push_back(i);
  const RefinedMotion refined = refine_motion(
      {a.camera, b.camera},
      feature_pairs({a.camera, a.features}, {b.camera, b.features}, matches, c.feature_sigma_px * pixel_m), agreeing,
      attitude_prior(a, b), {consensus.a_from_b, a.attitude, b.attitude}, c.inlier_sigmas);
  if (const auto wrong = implausible(c, refined, matches.size())) return tl::unexpected(*wrong);
  const PlanarState& state = refined.fit.state;
  const double overlap = share_of_b_seen_in_a(shown_a.plane, shown_b.plane, state.a_from_b);
  if (overlap < c.kappa) return refuse("little_overlap", overlap, c.kappa);
  if (gate) {
    if (const auto wrong = beyond_gate(*gate, state.a_from_b)) return tl::unexpected(*wrong);
  } else {
    const double spread =
        spread_of_agreement(matches, state.a_from_b, shown_a.at, shown_b.at, shown_a.plane.footprint, within_m);
    if (spread < c.least_spread) return refuse("little_spread", spread, c.least_spread);
  }
  // A guess keeps apart what lies farther than any guess may be off; nearer, it would have to be believed blindly.
  const double reach_m = gate ? std::max(c.widest_gate_m, 2.0 * gate->distance_m) : kAnywhereM;
  const double repeated =
      repeated_share(c, a, shown_a, shared_stretch(shown_a.at, shown_b.plane.footprint, state.a_from_b), reach_m,
                     refined.pairs.size(), within_m);
  if (repeated > c.most_repeated) return refuse("ambiguous", repeated, c.most_repeated);
  const double residual = std::accumulate(refined.residual_px.begin(), refined.residual_px.end(), 0.0) /
                          static_cast<double>(refined.pairs.size());
  return Related{Metric2{state.a_from_b, covariance_of(c, a, b, ceiling, refined.fit)},
                 static_cast<std::uint32_t>(refined.pairs.size()),
                 overlap,
                 residual,
                 {}};
}

}  // namespace weft::agents
