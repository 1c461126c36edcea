#include "agents/bodies/sim/hand.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "agents/bodies/sim/base.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kFarthestStartM = 1.5;
constexpr double kCheckEveryM = 0.05;
constexpr double kTurnFirstRad = 0.9;  // further off than this he turns the robot on the spot
constexpr double kTurnRate = 0.7;      // rad/s on the spot
constexpr double kSideways = 0.35;     // m/s^2 he dares in bends
constexpr double kBraking = 0.35;      // m/s^2
constexpr double kArrivedM = 0.02;

std::string text_of(const SitePoint& p) {
  char text[64];
  std::snprintf(text, sizeof text, "(%.2f, %.2f)", p.x, p.y);
  return text;
}

double length_of(const SitePoint& a, const SitePoint& b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

SitePoint between(const SitePoint& a, const SitePoint& b, double share) {
  return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

Result<void> check_clear(const SitePoint& p, const Site& site) {
  for (const Box& box : site.boxes) {
    if (const double gap = distance_to(box, p.x, p.y); gap < site.base.radius_m) {
      char text[200];
      std::snprintf(text, sizeof text, "the line passes %.2f m from %s at %s; the robot needs %.2f m", gap,
                    box.name.c_str(), text_of(p).c_str(), site.base.radius_m);
      return fail(ErrorCode::invalid, text);
    }
  }
  return {};
}

Result<void> check_line(const std::vector<SitePoint>& line, const Site& site, const Pose2& robot) {
  if (line.size() < 2) {
    return fail(ErrorCode::invalid, "the line has " + std::to_string(line.size()) + " points; at least 2 are needed");
  }
  for (const SitePoint& p : line) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
      return fail(ErrorCode::invalid, "the line has a point that is not finite");
    }
  }
  if (const double away = length_of({robot.x, robot.y}, line.front()); away > kFarthestStartM) {
    char text[200];
    std::snprintf(text, sizeof text, "the line starts at %s, %.2f m from where the robot stands; at most %.1f m",
                  text_of(line.front()).c_str(), away, kFarthestStartM);
    return fail(ErrorCode::invalid, text);
  }
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = length_of(line[i - 1], line[i]);
    const int steps = static_cast<int>(std::ceil(length / kCheckEveryM));
    for (int k = 0; k <= steps; ++k) {
      const double share = steps == 0 ? 0.0 : static_cast<double>(k) / steps;
      if (auto clear = check_clear(between(line[i - 1], line[i], share), site); !clear) {
        return clear;
      }
    }
  }
  return {};
}

}  // namespace

Result<Hand> Hand::along(const std::vector<SitePoint>& line, const Site& site, const Pose2& site_from_robot,
                         Random random) {
  if (auto checked = check_line(line, site, site_from_robot); !checked) {
    return fail(checked.error());
  }
  return Hand(site.hand, site.base, line, random);
}

Hand::Hand(const HandSetup& setup, const BaseSetup& base, std::vector<SitePoint> line, Random random)
    : setup_(setup),
      base_(base),
      line_(std::move(line)),
      aside_(1.0 / 8.0, 1.0 / 2.5, setup.wander_m, random.fork(1)),
      pace_(1.0 / 12.0, 1.0 / 3.0, setup.speed_wander_m_s, random.fork(2)) {
  along_m_.push_back(0.0);
  for (std::size_t i = 1; i < line_.size(); ++i) {
    along_m_.push_back(along_m_.back() + length_of(line_[i - 1], line_[i]));
  }
}

SitePoint Hand::point_at(double along_m) const {
  const double s = std::clamp(along_m, 0.0, along_m_.back());
  const auto after = std::upper_bound(along_m_.begin() + 1, along_m_.end() - 1, s);
  const auto i = static_cast<std::size_t>(after - along_m_.begin());
  const double length = along_m_[i] - along_m_[i - 1];
  return between(line_[i - 1], line_[i], length > 0.0 ? (s - along_m_[i - 1]) / length : 1.0);
}

Pose2 Hand::aim_at(double along_m) const {
  constexpr double kChordM = 0.05;
  const double end = along_m_.back();
  const SitePoint a = point_at(std::min(along_m, end - kChordM));
  const SitePoint b = point_at(std::min(along_m, end - kChordM) + kChordM);
  const double heading = std::atan2(b.y - a.y, b.x - a.x);
  // Past the end the line goes straight on, so that the last bit is driven like the rest.
  const double beyond = std::max(0.0, along_m - end);
  const SitePoint p = point_at(along_m);
  const double aside = aside_.at(along_m) * std::clamp((end - along_m) / 1.0, 0.0, 1.0);
  return {p.x + beyond * std::cos(heading) - aside * std::sin(heading),
          p.y + beyond * std::sin(heading) + aside * std::cos(heading), heading};
}

void Hand::follow_progress(const Pose2& robot) {
  // Forward only, and only nearby: a line that crosses itself must not be cut short.
  constexpr double kAheadM = 0.5;
  constexpr double kStepM = 0.005;
  double best = 1e9;
  double best_s = progress_m_;
  for (double s = progress_m_; s <= std::min(progress_m_ + kAheadM, along_m_.back()) + 1e-9; s += kStepM) {
    const double d = length_of(point_at(s), {robot.x, robot.y});
    if (d < best) {
      best = d;
      best_s = s;
    }
  }
  progress_m_ = best_s;
}

Twist Hand::command(const Pose2& site_from_robot, double time_s) {
  follow_progress(site_from_robot);
  const Pose2 site_from_last = aim_at(along_m_.back());
  const double left_m = along_m_.back() - progress_m_;
  const bool passed = left_m < setup_.lookahead_m && (site_from_last.inverse() * site_from_robot).x > -kArrivedM;
  if (at_end_ || passed) {
    at_end_ = true;
    return {};
  }
  const Pose2 site_from_aim = aim_at(progress_m_ + setup_.lookahead_m);
  const Eigen::Vector2d aim = site_from_robot.inverse() * site_from_aim.translation();
  const double bearing = std::atan2(aim.y(), aim.x());
  if (std::abs(bearing) > kTurnFirstRad) {
    return {0.0, std::copysign(kTurnRate, bearing)};
  }
  // Pure pursuit (Coulter 1992, eq. 3): the arc through the aim.
  const double curvature = 2.0 * aim.y() / aim.squaredNorm();
  double speed = setup_.speed_m_s + pace_.at(time_s);
  speed = std::min(speed, std::sqrt(kSideways / std::max(1e-3, std::abs(curvature))));
  speed = std::min(speed, std::sqrt(2.0 * kBraking * std::max(0.002, left_m)));
  speed = std::min({speed, base_.max_speed_m_s, base_.max_turn_rad_s / std::max(1e-3, std::abs(curvature))});
  return {speed, speed * curvature};
}

}  // namespace weft::agents::sim
