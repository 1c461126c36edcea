#include "agents/navigation/arrival.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents {

namespace {

constexpr double creep_m_s = 0.04;
constexpr double close_m = 0.006;            // where a creep ends
constexpr double close_rad = 0.0075;         // where a turn ends
constexpr double gain_1_s = 1.5;             // speed for each metre left
constexpr std::uint32_t most_moves = 12;     // then it gives up
constexpr std::uint32_t most_samples = 600;  // of one move: 20 s and more
constexpr std::uint32_t still_samples = 4;   // for the base to come to rest

}  // namespace

void Arrival::begin() {
  reset();
  phase_ = Phase::settle;
}

Arrival::Out Arrival::settled(const FollowConfig& config, const Pose2& robot_from_goal) {
  const double apart = robot_from_goal.translation().norm();
  if (apart <= config.arrive_m && std::abs(robot_from_goal.heading) <= config.arrive_rad) return {{}, true, {}};
  if (++moves_ > most_moves) return {{}, false, "goal_not_reached"};
  standing_ = 0;
  tracker_.reset();
  if (apart <= config.arrive_m) {
    turn_to(robot_from_goal);
  } else if (std::abs(robot_from_goal.y) <= 0.8 * config.arrive_m) {
    phase_ = Phase::creep;
    left_at_begin_ = robot_from_goal.x;
  } else {
    phase_ = Phase::face;
    left_at_begin_ = std::atan2(robot_from_goal.y, robot_from_goal.x);
  }
  return {};
}

Arrival::Out Arrival::settle() {
  phase_ = Phase::settle;
  standing_ = 0;
  moving_ = 0;
  return {};
}

void Arrival::turn_to(const Pose2& robot_from_goal) {
  phase_ = Phase::turn;
  left_at_begin_ = robot_from_goal.heading;
}

Arrival::Out Arrival::act(const FollowConfig& config, const TrackerConfig& tracker, const Pose2& robot_from_goal) {
  if (++moving_ > most_samples) return settle();
  const double apart = robot_from_goal.translation().norm();
  switch (phase_) {
    case Phase::creep: {
      const double left = robot_from_goal.x;
      if (std::abs(left) <= close_m || has_passed(left)) return settle();
      return {{std::copysign(std::min(creep_m_s, gain_1_s * std::abs(left)), left), 0.0}, false, {}};
    }
    case Phase::face: {
      const double left = std::atan2(robot_from_goal.y, robot_from_goal.x);
      const Twist turn = tracker_.turn(tracker, left, close_rad);
      if (turn.angular_rad_s == 0.0 || has_passed(left)) phase_ = Phase::approach;
      return {turn, false, {}};
    }
    case Phase::approach: {
      if (apart <= close_m || robot_from_goal.x <= 0.0) {
        turn_to(robot_from_goal);
        return {};
      }
      const double bearing = std::atan2(robot_from_goal.y, robot_from_goal.x);
      const double straight = apart > config.arrive_m ? std::clamp(bearing, -0.3, 0.3) : 0.0;
      return {{std::min(2.0 * creep_m_s, gain_1_s * apart), straight}, false, {}};
    }
    case Phase::turn: {
      const Twist turn = tracker_.turn(tracker, robot_from_goal.heading, close_rad);
      if (turn.angular_rad_s == 0.0 || has_passed(robot_from_goal.heading)) return settle();
      return {turn, false, {}};
    }
    case Phase::path:
    case Phase::settle:
      break;
  }
  return settle();
}

Arrival::Out Arrival::step(const FollowConfig& config, const TrackerConfig& tracker, const Pose2& robot_from_goal,
                           bool fresh) {
  if (phase_ != Phase::settle) return act(config, tracker, robot_from_goal);
  ++standing_;
  if (standing_ < still_samples || (!fresh && standing_ < config.settle_samples)) return {};
  return settled(config, robot_from_goal);
}

}  // namespace weft::agents
