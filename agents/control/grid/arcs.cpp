#include "agents/control/grid/arcs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace weft::agents {
namespace {

struct Window {
  double slowest_m_s, fastest_m_s, right_rad_s, left_rad_s;
};

Window window_of(const ArcConfig& config, const Twist& moving, double limit_m_s) {
  const double more = config.acceleration_m_s2 * config.period_s;
  const double less = config.deceleration_m_s2 * config.period_s;
  const double turn = config.acceleration_rad_s2 * config.period_s;
  const double most = std::min(config.fastest_m_s, limit_m_s);
  Window window{};
  window.slowest_m_s = std::max(0.0, moving.linear_m_s - less);
  window.fastest_m_s = std::max(window.slowest_m_s, std::min(most, moving.linear_m_s + more));
  window.right_rad_s = std::clamp(moving.angular_rad_s - turn, -config.fastest_rad_s, config.fastest_rad_s);
  window.left_rad_s = std::clamp(moving.angular_rad_s + turn, -config.fastest_rad_s, config.fastest_rad_s);
  return window;
}

double sample(double low, double high, int i, int count) {
  return low + (high - low) * static_cast<double>(i) / static_cast<double>(count - 1);
}

/// Describes where an arc leads while there is room.
struct Along {
  Pose2 end;
  double clear_m = 0.0;
  double least_m = 0.0;  ///< room on the way
};

Along look_along(const ArcConfig& config, const RoomToDrive& room, const Pose2& chart_from_robot, const Twist& arc) {
  // Steps reach to the horizon, and as far as the robot needs to stop; each is at most a cell long.
  const double metres = std::max(arc.linear_m_s * config.horizon_s, stop_distance_m(config, arc.linear_m_s));
  const int steps = std::max(1, static_cast<int>(std::ceil(metres / room.clearance().raster.cell_m)));
  const double time_s = metres / arc.linear_m_s / static_cast<double>(steps);
  const Pose2 step = se2_exp({arc.linear_m_s * time_s, 0.0, arc.angular_rad_s * time_s});
  Along along{chart_from_robot, 0.0, std::numeric_limits<double>::infinity()};
  for (int i = 0; i < steps; ++i) {
    const Pose2 next = along.end * step;
    const double clearance_m = room.clearance().at(next.translation());
    if (!room.allows(next.translation(), clearance_m)) break;
    along.end = next;
    along.clear_m += metres / static_cast<double>(steps);
    along.least_m = std::min(along.least_m, clearance_m);
  }
  return along;
}

/// Returns what an arc costs that ends there, metres.
double cost_of(const ArcConfig& config, const RoomToDrive& room, const Along& along, const Eigen::Vector2d& carrot) {
  const Eigen::Vector2d left = along.end.inverse() * carrot;
  const double narrow = std::max(0.0, room.radius_m() + config.comfort_m - along.least_m);
  const double off_rad = left.norm() > config.margin_m ? std::abs(std::atan2(left.y(), left.x())) : 0.0;
  return left.norm() + config.cost_of_heading_m * off_rad + config.cost_of_narrow * narrow;
}

}  // namespace

double stop_distance_m(const ArcConfig& config, double speed_m_s) {
  return speed_m_s * speed_m_s / (2.0 * config.deceleration_m_s2) + speed_m_s * config.delay_s + config.margin_m;
}

ChosenArc choose_arc(const ArcConfig& config, const RoomToDrive& room, const Pose2& chart_from_robot,
                     const Twist& moving, const Eigen::Vector2d& carrot, double limit_m_s) {
  constexpr double standing_m_s = 0.02;  // slower is not driving
  const Window window = window_of(config, moving, limit_m_s);
  ChosenArc best{{0.0, 0.0}, 0.0};
  double best_cost = std::numeric_limits<double>::infinity();
  for (int i = 0; i < config.speeds; ++i) {
    const double speed = sample(window.slowest_m_s, window.fastest_m_s, i, config.speeds);
    for (int j = 0; j < config.turns; ++j) {
      const double turn = sample(window.right_rad_s, window.left_rad_s, j, config.turns);
      Along along{chart_from_robot * Pose2{0.0, 0.0, turn * config.period_s}, 0.0,
                  room.clearance().at(chart_from_robot.translation())};
      const bool drives = speed > standing_m_s;
      if (drives) along = look_along(config, room, chart_from_robot, {speed, turn});
      if (drives && along.clear_m < stop_distance_m(config, speed)) continue;
      const double cost = cost_of(config, room, along, carrot);
      if (cost >= best_cost) continue;
      best_cost = cost;
      best = {{drives ? speed : 0.0, turn}, along.clear_m};
    }
  }
  return best;
}

}  // namespace weft::agents
