#include "clients/evaluate/floor/measures.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "agents/methods/advance.hpp"

namespace weft::evaluate::floor {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kWindowFrames = 5;
constexpr double kMovesMS = 0.1;
constexpr double kStretchM = 0.5;
constexpr double kJoinM = 1.0;
constexpr double kReachM = 1.0;  // along the path, from one sample to the next
constexpr double kDegree = std::numbers::pi / 180.0;

double length(const Pose2& pose) {
  return std::hypot(pose.x, pose.y);
}

bool is_within(const Pose2& off, double metres, double radians) {
  return length(off) <= metres && std::abs(off.heading) <= radians;
}

/// Returns whether a fix, as measured and as believed, is within both bounds of the truth.
bool is_fix_within(const Moment& moment, const std::map<PlaceId, Pose2>& site_from_place, double metres,
                   double radians) {
  const Pose2 robot_from_place = moment.site_from_robot.inverse() * site_from_place.at(moment.fix->place);
  return is_within(robot_from_place * moment.fix->measured, metres, radians) &&
         is_within(robot_from_place * moment.fix->believed, metres, radians);
}

double mean_off_percent(double sum_off, double sum_of) {
  return sum_of > 0.0 ? 100.0 * sum_off / sum_of : kNothing;
}

}  // namespace

std::vector<SpeedWindow> speed_windows(const Trace& trace) {
  std::vector<SpeedWindow> windows;
  const std::vector<Moment>& moments = trace.moments;
  for (std::size_t to = kWindowFrames; to < moments.size(); to += kWindowFrames) {
    const Moment& a = moments[to - kWindowFrames];
    const Moment& b = moments[to];
    const double taken_s = b.true_s - a.true_s;
    const double stamped_s = b.sensor_s - a.sensor_s;
    const double moved_m = length(a.start_from_robot.inverse() * b.start_from_robot);
    const double truly_m = length(a.site_from_robot.inverse() * b.site_from_robot);
    if (truly_m / taken_s <= kMovesMS) continue;
    windows.push_back({0.5 * (a.true_s + b.true_s), moved_m / taken_s, truly_m / taken_s, moved_m / stamped_s});
  }
  return windows;
}

SpeedError speed_error(const Trace& trace) {
  double off = 0.0;
  double stamped_off = 0.0;
  double sum = 0.0;
  for (const SpeedWindow& window : speed_windows(trace)) {
    off += std::abs(window.v_m_s - window.v_true_m_s);
    stamped_off += std::abs(window.v_stamped_m_s - window.v_true_m_s);
    sum += window.v_true_m_s;
  }
  return {mean_off_percent(off, sum), mean_off_percent(stamped_off, sum)};
}

std::vector<FixedStretch> fixed_stretches(const Trace& trace, const std::map<PlaceId, Pose2>& start_from_place) {
  std::vector<FixedStretch> stretches;
  const std::vector<double> driven = metres_driven(trace);
  const Moment* last = nullptr;
  double last_driven = 0.0;
  for (std::size_t i = 0; i < trace.moments.size(); ++i) {
    const Moment& now = trace.moments[i];
    if (!now.fix || (last != nullptr && driven[i] - last_driven < kStretchM)) continue;
    if (last != nullptr) {
      const double taken_s = now.true_s - last->true_s;
      const Pose2 there = start_from_place.at(last->fix->place) * last->fix->measured;
      const Pose2 here = start_from_place.at(now.fix->place) * now.fix->measured;
      stretches.push_back({0.5 * (now.true_s + last->true_s),
                           length(last->start_from_robot.inverse() * now.start_from_robot) / taken_s,
                           length(there.inverse() * here) / taken_s});
    }
    last = &now;
    last_driven = driven[i];
  }
  return stretches;
}

double consistency_percent(const std::vector<FixedStretch>& stretches) {
  double off = 0.0;
  double sum = 0.0;
  for (const FixedStretch& stretch : stretches) {
    off += std::abs(stretch.v_odometry_m_s - stretch.v_fixes_m_s);
    sum += stretch.v_odometry_m_s;
  }
  return mean_off_percent(off, sum);
}

std::vector<double> blind_distances(const Trace& trace, const std::map<PlaceId, Pose2>& site_from_place) {
  std::vector<double> distances;
  const std::vector<double> driven = metres_driven(trace);
  double last = 0.0;
  for (std::size_t i = 0; i < trace.moments.size(); ++i) {
    const Moment& now = trace.moments[i];
    if (!now.fix || !is_fix_within(now, site_from_place, 0.05, 2.0 * kDegree)) continue;
    distances.push_back(driven[i] - last);
    last = driven[i];
  }
  if (!driven.empty()) distances.push_back(driven.back() - last);
  return distances;
}

double wrong_fixes(const Trace& trace, const std::map<PlaceId, Pose2>& site_from_place) {
  return static_cast<double>(std::count_if(trace.moments.begin(), trace.moments.end(), [&](const Moment& moment) {
    return moment.fix && !is_fix_within(moment, site_from_place, 0.10, 3.0 * kDegree);
  }));
}

double fixes(const Trace& trace) {
  return static_cast<double>(std::count_if(trace.moments.begin(), trace.moments.end(),
                                           [](const Moment& moment) { return moment.fix.has_value(); }));
}

std::vector<Stretch> stretches(const Trace& trace, double metres) {
  std::vector<Stretch> all;
  const std::vector<Moment>& moments = trace.moments;
  const std::vector<double> driven = metres_driven(trace);
  double next_m = 0.0;
  for (std::size_t from = 0; from < moments.size(); ++from) {
    if (driven[from] < next_m) continue;
    next_m = driven[from] + 0.1 * metres;
    Relation moved = Metric2{};
    agents::CommonErrors common = agents::CommonErrors::Zero();
    std::size_t to = from;
    while (++to < moments.size()) {
      const Pose2 step = moments[to - 1].start_from_robot.inverse() * moments[to].start_from_robot;
      moved = agents::advanced(moved, {Metric2{step, moments[to].step_covariance}, true, {}, moments[to].step_common},
                               common);
      if (driven[to] - driven[from] >= metres) break;
    }
    if (to == moments.size()) break;
    const Pose2 truly = moments[from].site_from_robot.inverse() * moments[to].site_from_robot;
    all.push_back({se2_log(planar(moved).inverse() * truly), planar_covariance(moved)});
  }
  return all;
}

std::vector<double> distances2(const std::vector<Stretch>& stretches) {
  std::vector<double> all;
  for (const Stretch& stretch : stretches)
    all.push_back(stretch.off.dot(stretch.covariance.ldlt().solve(stretch.off)));
  return all;
}

double held_percent(const std::vector<double>& distances2) {
  constexpr double region_95 = 7.8147;
  if (distances2.empty()) return kNothing;
  const auto held = std::count_if(distances2.begin(), distances2.end(), [](double d2) { return d2 <= region_95; });
  return 100.0 * static_cast<double>(held) / static_cast<double>(distances2.size());
}

std::vector<OffPath> off_path(const Trace& trace, const TaughtPath& path) {
  std::vector<OffPath> off;
  if (trace.moments.empty() || path.poses().size() < 2) return off;
  const std::vector<double> driven = metres_driven(trace);
  double along = path.nearest(trace.moments.front().site_from_robot).along_m;
  for (std::size_t i = 1; i < trace.moments.size(); ++i) {
    const Moment& now = trace.moments[i];
    const TaughtPath::Nearest nearest = path.nearest(now.site_from_robot, along, kReachM);
    along = nearest.along_m;
    if (driven[i] < kJoinM) continue;
    const double v = (driven[i] - driven[i - 1]) / (now.true_s - trace.moments[i - 1].true_s);
    off.push_back({now.true_s, driven[i], nearest.lateral_m, nearest.heading_rad, v > kMovesMS});
  }
  return off;
}

PathErrors path_errors(const std::vector<OffPath>& off) {
  double squares = 0.0;
  double worst = off.empty() ? kNothing : 0.0;
  double heading_squares = 0.0;
  double moving = 0.0;
  double samples = 0.0;
  double last_m = -1.0;
  for (const OffPath& now : off) {
    worst = std::max(worst, std::abs(now.lateral_m));
    if (now.driven_m - last_m >= 0.001) {  // standing at one spot counts once
      squares += now.lateral_m * now.lateral_m;
      samples += 1.0;
      last_m = now.driven_m;
    }
    if (!now.moves) continue;
    heading_squares += now.heading_rad * now.heading_rad;
    moving += 1.0;
  }
  return {samples > 0.0 ? std::sqrt(squares / samples) : kNothing, worst,
          moving > 0.0 ? std::sqrt(heading_squares / moving) : kNothing};
}

}  // namespace weft::evaluate::floor
