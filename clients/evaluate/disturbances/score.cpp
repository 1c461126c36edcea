#include "clients/evaluate/disturbances/score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace weft::evaluate {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kSpeedWindowS = 0.5;
constexpr double kDriftOverM = 10.0;
constexpr double kDriftEveryM = 1.0;
constexpr double kRightM = 0.05;
constexpr double kRightDeg = 2.0;

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return kNothing;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
}

double length(const Pose2& pose) {
  return std::hypot(pose.x, pose.y);
}

/// Appends squared differences of measured and true speed; standing still is left out, it has none to measure.
void add_speed_errors(const std::vector<Frame>& run, std::vector<double>& squares) {
  for (std::size_t from = 0, to = 1; to < run.size(); ++to) {
    const double taken = run[to].true_s - run[from].true_s;
    if (taken < kSpeedWindowS) continue;
    const double moved = length(run[from].site_from_robot.inverse() * run[to].site_from_robot);
    const double measured = length(run[from].start_from_robot.inverse() * run[to].start_from_robot);
    const double stamped = run[to].sensor_s - run[from].sensor_s;
    if (moved > 0.05 && stamped > 0.0) {
      const double off = measured / stamped - moved / taken;
      squares.push_back(off * off);
    }
    from = to;
  }
}

void add_drift(const std::vector<Frame>& run, std::vector<double>& metres, std::vector<double>& radians) {
  std::vector<double> along(run.size(), 0.0);
  for (std::size_t i = 1; i < run.size(); ++i) {
    along[i] = along[i - 1] + length(run[i - 1].site_from_robot.inverse() * run[i].site_from_robot);
  }
  double next = 0.0;
  for (std::size_t from = 0; from < run.size(); ++from) {
    if (along[from] < next) continue;
    next = along[from] + kDriftEveryM;
    const auto end = std::lower_bound(along.begin(), along.end(), along[from] + kDriftOverM);
    if (end == along.end()) return;
    const auto to = static_cast<std::size_t>(end - along.begin());
    const Pose2 moved = run[from].site_from_robot.inverse() * run[to].site_from_robot;
    const Pose2 off = moved.inverse() * (run[from].start_from_robot.inverse() * run[to].start_from_robot);
    metres.push_back(length(off));
    radians.push_back(std::abs(off.heading));
  }
}

void score_fixes(const std::vector<Attempt>& attempts, Score& score) {
  std::vector<double> metres;
  std::vector<double> degrees;
  double right = 0.0;
  for (const Attempt& attempt : attempts) {
    if (!attempt.related) continue;
    const Pose2 off = attempt.place_from_robot.inverse() * attempt.measured;
    metres.push_back(length(off));
    degrees.push_back(kDegrees * std::abs(off.heading));
    right += metres.back() <= kRightM && degrees.back() <= kRightDeg ? 1.0 : 0.0;
  }
  score.fix_mm = 1e3 * quantile(metres, 0.5);
  score.fix_95_mm = 1e3 * quantile(metres, 0.95);
  score.fix_deg = quantile(degrees, 0.5);
  score.fixes_percent = attempts.empty() ? kNothing : 100.0 * right / static_cast<double>(attempts.size());
  score.wrong_fixes = static_cast<double>(metres.size()) - right;
}

}  // namespace

Score score_of(const std::vector<std::vector<Frame>>& runs, const std::vector<Attempt>& attempts) {
  std::vector<double> squares;
  std::vector<double> metres;
  std::vector<double> radians;
  double blind = 0.0;
  double frames = 0.0;
  for (const std::vector<Frame>& run : runs) {
    add_speed_errors(run, squares);
    add_drift(run, metres, radians);
    frames += static_cast<double>(run.size());
    blind += static_cast<double>(std::count_if(run.begin(), run.end(), [](const Frame& f) { return !f.seen; }));
  }
  Score score;
  double sum = 0.0;
  for (const double square : squares) sum += square;
  score.speed_error_mm_s = squares.empty() ? kNothing : 1e3 * std::sqrt(sum / static_cast<double>(squares.size()));
  score.drift_mm = 1e3 * quantile(metres, 0.5);
  score.drift_deg = kDegrees * quantile(radians, 0.5);
  score.blind_percent = frames == 0.0 ? kNothing : 100.0 * blind / frames;
  score_fixes(attempts, score);
  return score;
}

}  // namespace weft::evaluate
