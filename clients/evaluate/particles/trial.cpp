#include "clients/evaluate/particles/trial.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "clients/evaluate/particles/odometry.hpp"
#include "clients/evaluate/particles/scan_map.hpp"

namespace weft::evaluate::particles {
namespace {

using namespace agents;

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) /
         static_cast<double>(std::max<std::size_t>(1, values.size()));
}

/// Drives a filter from odd scan to odd scan, and keeps account.
class Locating {
 public:
  Locating(const Course& course, const ParticleFilterConfig& config, std::uint64_t seed, std::size_t first)
      : course_(course),
        steps_(simulated_odometry(course.scans, {}, seed)),
        filter_(config, seed),
        at_(first),
        by_odometry_(course.scans[first].map_from_laser) {
    trial_.row.seed = seed;
  }
  ParticleFilter& filter() { return filter_; }
  bool is_over() const { return at_ >= course_.scans.size(); }
  std::size_t updates() const { return counts_.size(); }
  const Pose2& truth() const { return course_.scans[at_].map_from_laser; }

  /// Takes in the scan that it is at; returns whether the filter was updated.
  bool locate() {
    const bool is_due = filter_.is_due();
    if (is_due) {
      const Scan scan = scan_of_laser(course_.scans[at_]);
      const double began_s = course_.steady_s();
      filter_.update(course_.field, scan, DrawPose());  // as nav2 has it, recovery is off
      took_s_ += course_.steady_s() - began_s;
      counts_.push_back(static_cast<double>(filter_.particles().size()));
    }
    return is_due;
  }
  /// Notes how far off the estimate is at this scan.
  void judge() {
    const Pose2 located = filter_.estimate().chart_from_robot;
    const Pose2 off = truth().inverse() * located;
    trial_.truth.push_back(truth());
    trial_.located.push_back(located);
    off_m_.push_back(off.translation().norm());
    off_deg_.push_back(std::abs(off.heading) * 180.0 / std::numbers::pi);
    odometry_m_.push_back((by_odometry_.translation() - truth().translation()).norm());
    in_a_row_ = off_m_.back() > kLostM ? in_a_row_ + 1 : 0;
    trial_.row.is_lost = trial_.row.is_lost || in_a_row_ >= kLostScans;
  }
  /// Drops what was noted: it was right by chance.
  void forget() {
    trial_.truth.clear();
    trial_.located.clear();
    for (std::vector<double>* const noted : {&off_m_, &off_deg_, &odometry_m_}) noted->clear();
    in_a_row_ = 0;
    trial_.row.is_lost = false;
  }
  bool is_right() const {
    const Pose2 off = truth().inverse() * filter_.estimate().chart_from_robot;
    return off.translation().norm() < kFoundM && std::abs(off.heading) < kFoundRad;
  }
  /// Goes on to the next odd scan.
  void go_on() {
    if (at_ + 2 < course_.scans.size()) {
      const Pose2 step = steps_[at_ + 1] * steps_[at_ + 2];
      by_odometry_ = by_odometry_ * step;
      filter_.advance(motion_of(step, course_.alpha));
    }
    at_ += 2;
  }
  Trial finish(double found_after) {
    TrialRow& row = trial_.row;
    row.located = off_m_.size();
    row.found_after = found_after;
    row.mean_m = mean(off_m_);
    row.heading_mean_deg = mean(off_deg_);
    row.odometry_mean_m = mean(odometry_m_);
    row.particles = mean(counts_);
    row.update_ms = 1e3 * took_s_ / static_cast<double>(std::max<std::size_t>(1, counts_.size()));
    std::sort(off_m_.begin(), off_m_.end());
    row.worst_m = off_m_.empty() ? 0.0 : off_m_.back();
    row.p95_m = off_m_.empty() ? 0.0 : off_m_[(off_m_.size() - 1) * 95 / 100];
    return std::move(trial_);
  }

 private:
  const Course& course_;
  std::vector<Pose2> steps_;
  ParticleFilter filter_;
  std::size_t at_;
  Pose2 by_odometry_;
  Trial trial_;
  std::vector<double> off_m_;
  std::vector<double> off_deg_;
  std::vector<double> odometry_m_;
  std::vector<double> counts_;
  double took_s_ = 0.0;
  std::size_t in_a_row_ = 0;
};

}  // namespace

std::optional<Trial> follow(const Course& course, std::uint64_t seed) {
  constexpr double off_m = 0.1;
  constexpr double off_rad = 0.05;
  constexpr std::size_t particles = 1000;
  Locating locating(course, {}, seed, 1);
  const Eigen::Vector3d variances(off_m * off_m, off_m * off_m, off_rad * off_rad);
  locating.filter().begin_at(locating.truth(), variances.asDiagonal(), particles);
  for (; !locating.is_over(); locating.go_on()) {
    if (course.asked_to_stop()) return std::nullopt;
    locating.locate();
    locating.judge();
  }
  return locating.finish(0.0);
}

std::optional<Trial> find(const Course& course, std::uint64_t seed) {
  constexpr std::size_t most_updates = 200;
  constexpr std::size_t updates_after = 60;
  ParticleFilterConfig config;
  config.kld.most = static_cast<int>(kAnywhereParticles);
  Random random = Random(seed).fork(1);
  Locating locating(course, config, seed, 1 + 2 * random.below(course.scans.size() / 4));
  locating.filter().begin_anywhere(course.anywhere, kAnywhereParticles);
  std::size_t right_since = 0;  // the update from which on it was right; 0: it is not
  for (; !locating.is_over() && locating.updates() < most_updates; locating.go_on()) {
    if (course.asked_to_stop()) return std::nullopt;
    const bool was_updated = locating.locate();
    if (was_updated && right_since == 0 && locating.is_right()) right_since = locating.updates();
    if (right_since > 0 && locating.updates() < right_since + kFoundUpdates && !locating.is_right()) {
      right_since = 0;
      locating.forget();
    }
    if (right_since > 0) locating.judge();
    if (right_since > 0 && locating.updates() >= right_since + updates_after) break;
  }
  const bool is_found = right_since > 0 && locating.updates() >= right_since + kFoundUpdates;
  return locating.finish(is_found ? static_cast<double>(right_since) : std::numeric_limits<double>::quiet_NaN());
}

}  // namespace weft::evaluate::particles
