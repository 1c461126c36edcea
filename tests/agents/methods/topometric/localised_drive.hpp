#pragma once
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "tests/agents/methods/topometric/made_site.hpp"

namespace weft::agents {

/// Returns a corridor 1.8 m wide along x, from -3 to 23 m, with niches and pillars 0.15 m deep at odd distances.
inline MadeSite niched_corridor() {
  MadeSite site;
  site.add_box(-3.0, -0.9, 23.0, 0.9);
  double at_m = -1.5;
  for (const double next_m : {2.7, 3.9, 3.1, 4.6, 2.9, 3.7, 3.3}) {
    site.add_box(at_m, 0.75, at_m + 0.9, 0.9);
    site.add_box(at_m + 1.7, -0.9, at_m + 2.1, -0.75);
    at_m += next_m;
  }
  site.add_landmarks(0.3, 5);
  return site;
}

/// Drives a robot through a taught site and tells a method what it sees, with charts about the nearest place whenever
/// it has left the middle of one: as navigation does.
class LocalisedDrive {
 public:
  LocalisedDrive(const MadeSite& site, const TaughtSite& taught, const TopometricConfig& config, std::uint64_t seed)
      : site_(site), taught_(taught), method_(made_method(config)), random_(seed) {}
  LocalisedDrive(const MadeSite&& temporary, const TaughtSite& taught, const TopometricConfig& config,
                 std::uint64_t seed) = delete;

  /// Puts it there; it believes to be at `believed`, as surely as `sigma_m` says.
  void begin(const Pose2& truth, const Pose2& believed, double sigma_m, double sigma_rad) {
    truth_ = truth;
    make_chart(nearest(believed));
    Metric2 place_from_robot{taught_.site_from_places[centre_].inverse() * believed};
    place_from_robot.covariance.diagonal() =
        Eigen::Vector3d(sigma_m * sigma_m, sigma_m * sigma_m, sigma_rad * sigma_rad);
    belief_ = method_.begin(*chart_, {TaughtSite::id(centre_), place_from_robot, 0.0});
  }

  /// Drives a step and looks; `is_dark`: it sees nothing, and its step is as uncertain as commands are.
  Located<TopometricBelief> next(const Pose2& step, bool is_dark = false) {
    const double share = is_dark ? 0.15 : 0.02;
    const Eigen::Vector3d sigmas(0.001 + share * std::abs(step.x), 0.001 + 0.5 * share * std::abs(step.x),
                                 0.001 + share * std::abs(step.heading) + 0.2 * share * std::abs(step.x));
    const Eigen::Vector3d error(random_.normal(0.0, sigmas.x()), random_.normal(0.0, sigmas.y()),
                                random_.normal(0.0, sigmas.z()));
    truth_ = truth_ * step * se2_exp(error);
    Metric2 told{step};
    told.covariance = sigmas.cwiseAbs2().asDiagonal();
    if (const std::size_t near = nearest(estimate()); apart(near, centre_) > 6) switch_to(near);
    TopometricContent seen = site_.view_from(truth_, random_);
    if (is_dark) seen = {};
    Located<TopometricBelief> located = method_.locate(*chart_, belief_, {told, !is_dark, {}}, seen);
    belief_ = located.belief;
    return located;
  }

  const Pose2& truth() const { return truth_; }
  /// Returns where its particles take it to be, in the site.
  Pose2 estimate() const { return taught_.site_from_places[centre_] * belief_.estimate().chart_from_robot; }
  double off_m() const { return (estimate().translation() - truth_.translation()).norm(); }
  double largest_jump_m() const { return largest_jump_m_; }
  int switches() const { return switches_; }
  TopometricBelief& belief() { return belief_; }
  const TopometricChart& chart() const { return *chart_; }
  const Topometric& method() const { return method_; }
  Pose2 of_fix(const Fix& fix) const {
    return taught_.site_from_places[fix.place.index] * planar(fix.place_from_robot);
  }
  /// Returns the squared Mahalanobis distance of a fix from the truth, in the plane.
  double nees(const Fix& fix) const {
    const Eigen::Vector3d off = se2_log(of_fix(fix).inverse() * truth_);
    return off.dot(planar_covariance(fix.place_from_robot).inverse() * off);
  }

 private:
  static std::size_t apart(std::size_t a, std::size_t b) { return a > b ? a - b : b - a; }
  std::size_t nearest(const Pose2& at) const {
    const auto found = std::min_element(
        taught_.site_from_places.begin(), taught_.site_from_places.end(), [&](const Pose2& a, const Pose2& b) {
          return (a.translation() - at.translation()).norm() < (b.translation() - at.translation()).norm();
        });
    return static_cast<std::size_t>(found - taught_.site_from_places.begin());
  }
  void make_chart(std::size_t centre) {
    centre_ = centre;
    chart_.emplace(method_.chart(taught_.around(centre)));
  }
  void switch_to(std::size_t centre) {
    const Pose2 before = estimate();
    const TopometricBelief old = belief_;
    make_chart(centre);
    const Relation place_from_robot = Metric2{taught_.site_from_places[centre].inverse() * before};
    belief_ = method_.carried(*chart_, {TaughtSite::id(centre), place_from_robot, 0.0}, old);
    largest_jump_m_ = std::max(largest_jump_m_, (estimate().translation() - before.translation()).norm());
    ++switches_;
  }

  const MadeSite& site_;
  const TaughtSite& taught_;
  Topometric method_;
  Random random_;
  Pose2 truth_;
  std::size_t centre_ = 0;
  std::optional<TopometricChart> chart_;
  TopometricBelief belief_;
  double largest_jump_m_ = 0.0;
  int switches_ = 0;
};

}  // namespace weft::agents
