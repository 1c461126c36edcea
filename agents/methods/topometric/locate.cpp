// Locates the robot among its particles (Dayoub et al. 2013, III-B): they move by each step's own covariance and are
// weighed by the scan and, beyond the paper, by the features that a place nearby shows too. A bare corridor tells
// nothing along itself.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "agents/methods/advance.hpp"
#include "agents/methods/topometric/feature_pose.hpp"
#include "agents/methods/topometric/topometric.hpp"

namespace weft::agents {
namespace {

/// Holds how a scan fits from a pose: how likely a beam ends where it does where the chart knows anything, the
/// geometric mean, and the share of beams that end there.
struct ScanFit {
  double likelihood = 1.0;
  double known = 0.0;
};

ScanFit fit_of_scan(const LikelihoodField& field, const Scan& scan, const Pose2& chart_from_robot) {
  const std::vector<BeamEnd> all = field.ends_of(scan);
  std::vector<BeamEnd> known;
  for (const BeamEnd& end : all)
    if (field.knows(chart_from_robot, end)) known.push_back(end);
  if (known.empty()) return {};
  ParticleSet here;
  here.add(chart_from_robot, 1.0);
  std::vector<float> logs(1, 0.0F);
  field.weigh(known, here, logs);
  const auto count = static_cast<double>(known.size());
  return {std::exp(static_cast<double>(logs.front()) / count), count / static_cast<double>(all.size())};
}

bool has_return(const Scan& scan) {
  return std::any_of(scan.beams.begin(), scan.beams.end(),
                     [](const Beam& beam) { return beam.kind != Beam::Return::none; });
}

/// Lifts a planar covariance to space: the robot stands on the floor.
Matrix6d on_the_floor(const Eigen::Matrix3d& planar) {
  constexpr double height_sigma_m = 0.01;
  constexpr double tilt_sigma_rad = 0.005;
  constexpr std::array<Eigen::Index, 3> in_space = {0, 1, 5};
  Matrix6d covariance = Matrix6d::Zero();
  covariance(2, 2) = height_sigma_m * height_sigma_m;
  covariance(3, 3) = covariance(4, 4) = tilt_sigma_rad * tilt_sigma_rad;
  for (Eigen::Index row = 0; row < 3; ++row)
    for (Eigen::Index column = 0; column < 3; ++column)
      covariance(in_space[static_cast<std::size_t>(row)], in_space[static_cast<std::size_t>(column)]) =
          planar(row, column);
  return covariance;
}

/// Returns the particles' covariance with the map's own error, which all of them share.
Eigen::Matrix3d with_map_error(const TopometricBeliefConfig& config, const Eigen::Matrix3d& covariance) {
  const double map_m2 = config.map_sigma_m * config.map_sigma_m;
  const double map_rad2 = config.map_sigma_rad * config.map_sigma_rad;
  Eigen::Matrix3d all = 0.5 * (covariance + covariance.transpose());
  all.diagonal() += Eigen::Vector3d(map_m2, map_m2, map_rad2);
  return all;
}

/// Returns a motion with what odometry errs by all the way. Without it particles of a robot whose calibration is off
/// in another way than that of the one which taught lie within millimetres of odometry, and no look pulls them back.
UncertainMotion with_drift(const TopometricBeliefConfig& config, UncertainMotion motion) {
  const double metres = motion.previous_from_current.translation().norm();
  motion.covariance.diagonal() +=
      metres * Eigen::Vector3d(config.drift_m * config.drift_m, config.drift_m * config.drift_m,
                               config.drift_rad * config.drift_rad);
  return motion;
}

/// Returns why nothing is to be made of where particles are; none: they tell.
std::optional<Refusal> too_spread(const TopometricBeliefConfig& config, const ParticleEstimate& estimate) {
  if (estimate.share < config.least_share) return Refusal{"spread", estimate.share, config.least_share};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solved(estimate.covariance.topLeftCorner<2, 2>(),
                                                              Eigen::EigenvaluesOnly);
  const double sigma_m = std::sqrt(std::max(0.0, solved.eigenvalues().maxCoeff()));
  if (sigma_m > config.most_sigma_m) return Refusal{"spread", sigma_m, config.most_sigma_m};
  const double sigma_rad = std::sqrt(std::max(0.0, estimate.covariance(2, 2)));
  if (sigma_rad > config.most_sigma_rad) return Refusal{"spread", sigma_rad, config.most_sigma_rad};
  return std::nullopt;
}

/// Returns why a scan that no features confirm is not to be trusted; none: it is. `is_new`: it was just weighed.
std::optional<Refusal> doubt_of(const TopometricBeliefConfig& config, const ScanFit& fit, bool is_new,
                                std::uint32_t& fits_to_come) {
  std::optional<Refusal> doubt;
  if (fit.likelihood < config.least_likelihood) doubt = {"scan_differs", fit.likelihood, config.least_likelihood};
  if (fit.known < config.least_known) doubt = {"off_the_known", fit.known, config.least_known};
  if (doubt) {
    fits_to_come = static_cast<std::uint32_t>(config.fits_after_doubt);
    return doubt;
  }
  if (fits_to_come == 0) return std::nullopt;
  const double fits = config.fits_after_doubt - static_cast<double>(fits_to_come);
  if (is_new) --fits_to_come;
  return Refusal{"doubted", fits, static_cast<double>(config.fits_after_doubt)};
}

/// Holds what features say, and how many.
struct ToldByFeatures {
  ToldPose pose;
  std::uint32_t inliers = 0;
};

/// Returns where features of the nearest place that was seen with about the same heading see the robot.
std::optional<ToldByFeatures> told_by_features(const TopometricConfig& all, const TopometricChart& chart,
                                               const Pose2& centre_from_robot, const TopometricContent& seen) {
  const TopometricBeliefConfig& config = all.belief;
  if (!config.uses_features || seen.features.empty()) return std::nullopt;
  const TopometricPlace* const place =
      chart.nearest(centre_from_robot.translation(), [&](const TopometricPlace& one) {
        const double turned = wrap_angle(centre_from_robot.heading - one.centre_from_place.heading);
        return one.content && !one.content->features.empty() && std::abs(turned) < config.feature_turn_rad;
      });
  if (place == nullptr) return std::nullopt;
  const double apart_m = (place->centre_from_place.translation() - centre_from_robot.translation()).norm();
  if (apart_m > config.feature_reach_m) return std::nullopt;
  const std::optional<FeaturePose> found = pose_by_features(all.relate, *place->content, seen);
  if (!found) return std::nullopt;
  ToldByFeatures told{{place->centre_from_place * found->place_from_robot}, found->inliers};
  told.pose.covariance = with_map_error(config, config.looks_alike * found->covariance);
  return told;
}

/// Returns the fix at the nearest place.
Fix fix_at(const TopometricBeliefConfig& config, const TopometricPlace& place, const ParticleEstimate& estimate) {
  Fix fix;
  fix.place = place.id;
  const Pose2 place_from_robot = place.centre_from_place.inverse() * estimate.chart_from_robot;
  fix.place_from_robot = Metric3{lift(place_from_robot), on_the_floor(with_map_error(config, estimate.covariance))};
  fix.evidence.a_from_b = fix.place_from_robot;
  return fix;
}

}  // namespace

Located<Topometric::Belief> Topometric::locate(const Chart& chart, Belief belief, const Step& step,
                                               const Content& seen) const {
  Located<Belief> located{std::move(belief), std::nullopt, {}};
  Belief& now = located.belief;
  const auto refused = [&](const Refusal& refusal) {
    located.refusals.push_back(refusal);
    return std::move(located);
  };
  if (!now.filter) return refused({"no_particles"});
  now.since = now.since ? joined(*now.since, step) : step;
  if (!seen.scan) return refused({"no_scan"});
  ParticleFilter filter = *now.filter;
  filter.advance(with_drift(config_.belief, motion_of(*now.since)));
  std::optional<ToldByFeatures> told;
  const bool is_new = filter.is_due();
  if (is_new) {
    told = told_by_features(config_, chart, now.estimate().chart_from_robot, seen);
    if (!told && !has_return(*seen.scan)) return refused({"no_scan", 0.0, 1.0});
    // An aisle looks the same from both its ends: what a scan alone finds elsewhere is not to be trusted. Who is lost
    // is found by features.
    const DrawPose anywhere = config_.belief.uses_features ? DrawPose() : chart.anywhere_free();
    filter.update(chart.field, *seen.scan, anywhere, told ? std::optional(told->pose) : std::nullopt);
    now.filter = std::move(filter);
    now.since.reset();
    now.is_guess = now.is_guess && !told;
    now.recognised = told ? told->inliers : 0;
  }
  const ParticleEstimate estimate = now.estimate();
  if (const std::optional<Refusal> spread = too_spread(config_.belief, estimate)) return refused(*spread);
  if (now.is_guess) return refused({"not_recognised", 0.0, 1.0});
  const Eigen::Vector2d at = estimate.chart_from_robot.translation();
  const TopometricPlace* const place = chart.nearest(at, [](const TopometricPlace&) { return true; });
  if (place == nullptr || !chart.grid.raster.holds(chart.grid.raster.cell_at(at)))
    return refused({"off_the_chart", at.cwiseAbs().maxCoeff(), 0.5 * config_.chart.side_m});
  const ScanFit fit = fit_of_scan(chart.field, *seen.scan, estimate.chart_from_robot);
  if (now.recognised < static_cast<std::uint32_t>(config_.belief.sure_features) && has_return(*seen.scan)) {
    if (const auto doubt = doubt_of(config_.belief, fit, is_new, now.fits_to_come)) return refused(*doubt);
  } else {
    now.fits_to_come = 0;
  }
  located.fix = fix_at(config_.belief, *place, estimate);
  located.fix->evidence.inliers = now.recognised;
  located.fix->evidence.overlap = fit.known;
  located.fix->evidence.residual = 1.0 - fit.likelihood;
  return located;
}

}  // namespace weft::agents
