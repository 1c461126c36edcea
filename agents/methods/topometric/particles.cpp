// Particles from one chart to the next (contract, T3).
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/methods/topometric/topometric.hpp"

namespace weft::agents {
namespace {

/// Returns a seed of its own for each place, so that equal drives draw equal particles.
std::uint64_t seed_of(const PlaceId& place) {
  return place.experience.value ^ (std::uint64_t{place.index} << 32U) ^ 0x746F706FU;
}

/// Returns the relation of two charts by the place that both have nearest to the robot: there nothing moves, whatever
/// a loop has bent elsewhere. None: they have none in common.
std::optional<Pose2> new_from_old(const TopometricPlaces& before, const TopometricChart& now,
                                  const Eigen::Vector2d& in_old) {
  const TopometricPlace* old = nullptr;
  const TopometricPlace* same = nullptr;
  double least_m = 0.0;
  for (const TopometricPlace& place : before) {
    const double apart_m = (place.centre_from_place.translation() - in_old).norm();
    if (old != nullptr && apart_m >= least_m) continue;
    const TopometricPlace* const found = now.find(place.id);
    if (found == nullptr) continue;
    old = &place;
    same = found;
    least_m = apart_m;
  }
  if (old == nullptr) return std::nullopt;
  return same->centre_from_place * old->centre_from_place.inverse();
}

/// Returns an estimate in the frame of the chart's centre; none: its place is not in the chart.
std::optional<UncertainMotion> in_chart(const TopometricChart& chart, const Estimate& estimate) {
  const TopometricPlace* const place = chart.find(estimate.place);
  if (place == nullptr) return std::nullopt;
  return UncertainMotion{place->centre_from_place * planar(estimate.place_from_robot),
                         planar_covariance(estimate.place_from_robot)};
}

}  // namespace

static_assert(ChartsItself<Topometric>);
static_assert(CarriesBelief<Topometric>);

UncertainMotion motion_of(const Step& step) {
  return {planar(step.previous_from_current), planar_covariance(step.previous_from_current)};
}

ParticleEstimate TopometricBelief::estimate() const {
  const ParticleEstimate last = filter->estimate();
  if (!since) return last;
  const UncertainMotion now = UncertainMotion{last.chart_from_robot, last.covariance} * motion_of(*since);
  return {now.previous_from_current, now.covariance, last.share};
}

Topometric::Belief Topometric::begin(const Chart& chart, const Estimate& seed) const {
  Belief belief{std::nullopt, std::nullopt, chart.places, false, 0, 0};
  const std::optional<UncertainMotion> at = in_chart(chart, seed);
  if (!at) return belief;
  Eigen::Matrix3d covariance = at->covariance;
  const double sure_m2 = config_.belief.sure_seed_m * config_.belief.sure_seed_m;
  belief.is_guess = config_.belief.uses_features && std::max(covariance(0, 0), covariance(1, 1)) > sure_m2;
  const double least_m2 = config_.belief.least_sigma_m * config_.belief.least_sigma_m;
  const double least_rad2 = config_.belief.least_sigma_rad * config_.belief.least_sigma_rad;
  covariance.diagonal() += Eigen::Vector3d(least_m2, least_m2, least_rad2);
  belief.filter.emplace(config_.filter, seed_of(seed.place));
  belief.filter->begin_at(at->previous_from_current, covariance, static_cast<std::size_t>(config_.belief.particles));
  return belief;
}

Topometric::Belief Topometric::carried(const Chart& chart, const Estimate& seed, const Belief& before) const {
  if (!before.filter || !before.places) return begin(chart, seed);
  const Eigen::Vector2d at = before.estimate().chart_from_robot.translation();
  const std::optional<Pose2> moved = new_from_old(*before.places, chart, at);
  if (!moved) return begin(chart, seed);
  Belief belief = before;
  belief.places = chart.places;
  belief.filter->carry_to(*moved);
  return belief;
}

Topometric::Belief Topometric::believed(const Chart& chart, const Belief& before, const Estimate& estimate) const {
  const std::optional<UncertainMotion> told = in_chart(chart, estimate);
  if (!told) return before;
  if (!before.filter) return begin(chart, estimate);
  const ParticleEstimate own = before.estimate();
  const Eigen::Vector3d off = se2_log(own.chart_from_robot.inverse() * told->previous_from_current);
  Eigen::Matrix3d covariance = own.covariance + told->covariance;
  const double least_m2 = config_.belief.least_sigma_m * config_.belief.least_sigma_m;
  const double least_rad2 = config_.belief.least_sigma_rad * config_.belief.least_sigma_rad;
  covariance.diagonal() += Eigen::Vector3d(least_m2, least_m2, least_rad2);
  const double sigmas = std::sqrt(std::max(0.0, off.dot(covariance.inverse() * off)));
  return sigmas <= config_.belief.overruled_sigmas ? before : begin(chart, estimate);
}

}  // namespace weft::agents
