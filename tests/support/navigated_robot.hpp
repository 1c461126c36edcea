#pragma once
#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "agents/control/tracker.hpp"
#include "agents/navigation/navigator.hpp"
#include "tests/support/little_server.hpp"
#include "tests/support/marks_world.hpp"

namespace weft::test {

/// Tells where places truly are: for judging only.
using Truth = std::map<PlaceId, Pose2>;

/// Simulates a robot on a floor of marks with a navigator, and a hand that drives it along a path in the site frame.
class NavigatedRobot {
 public:
  NavigatedRobot(const MarksWorld& world, const MarksRobotConfig& config, const Pose2& start, std::uint64_t seed,
                 std::unique_ptr<agents::Navigator> navigator)
      : body_(world, config, start, seed), navigator_(std::move(navigator)) {}

  agents::Navigator& navigator() { return *navigator_; }
  const Pose2& world_from_robot() const { return body_.world_from_robot(); }

  /// Takes one sample: the body moves by the last command, then the navigator sees.
  agents::Navigated step(const agents::MapView& map, bool hand = false) {
    agents::Sample sample = body_.step(command_);
    sample.hand = hand;
    if (blind) sample.views.clear();
    for (agents::View& view : sample.views) {
      if (dark) view.data = agents::Marks{};
      if (elsewhere) view.data = body_.look_from(*elsewhere);
    }
    if (looks) looks(sample, world_from_robot());
    agents::Navigated navigated = navigator_->step(sample, map);
    if (!hand) command_ = navigated.command;
    for (const agents::Refusal& refusal : navigated.refusals) ++refusals[std::string(refusal.reason)];
    return navigated;
  }

  /// Teaches an experience along `path` (site frame); hands it in place by place when `live`, else at the end.
  void teach(LittleServer& server, ExperienceId experience, const std::vector<Pose2>& path, Truth& truth,
             bool live = true) {
    const RobotId robot{{static_cast<std::uint8_t>(experience.value)}};
    navigator_->begin_teach({experience, robot});
    std::vector<agents::Kept> all;
    const auto take = [&](std::vector<agents::Kept> kept) {
      for (const agents::Kept& one : kept) truth[one.place.id] = world_from_robot();
      if (live) server.take(experience, robot, navigator_->method(), kept);
      std::move(kept.begin(), kept.end(), std::back_inserter(all));
    };
    hand(path, [&] { take(step(server.map(), true).kept); });
    for (take(navigator_->end_teach(server.map())); navigator_->is_taught();
         take(navigator_->end_teach(server.map())))
      take(step(server.map(), true).kept);
    if (!live) server.take(experience, robot, navigator_->method(), all);
  }

  /// Drives the robot by hand along the path and stops at its end.
  template <class Step>
  void hand(const std::vector<Pose2>& path, Step&& one_step) {
    agents::Tracker tracker;
    const agents::TrackerConfig config;
    double speed = 0.0;
    std::size_t passed = 0;
    int standing = 0;
    for (int i = 0; i < 20'000 && standing < 8; ++i) {
      const Pose2 robot_from_world = world_from_robot().inverse();
      std::vector<Pose2> near;
      while (passed + 2 < path.size() && (path[passed + 1].inverse() * world_from_robot()).x > 0.1) ++passed;
      for (std::size_t k = passed; k < path.size() && k < passed + 15; ++k)
        near.push_back(robot_from_world * path[k]);
      const auto spline = agents::Spline::through(near);
      const auto tracked = tracker.track(config, spline.value(), 0.5, {speed, true, from_seconds(body_.elapsed_s())});
      standing = tracked.at_end && passed + 15 >= path.size() ? standing + 1 : 0;
      const Pose2 before = world_from_robot();
      command_ = tracked.command;
      one_step();
      speed = (before.inverse() * world_from_robot()).x / body_.elapsed_s();
    }
    command_ = {};
  }

  /// Turns on the spot by hand.
  template <class Step>
  void spin(double rate_rad_s, double radians, Step&& one_step) {
    const double goal = world_from_robot().heading + radians;
    command_ = {0.0, std::copysign(rate_rad_s, radians)};
    while (std::abs(wrap_angle(goal - world_from_robot().heading)) > 0.08) one_step();
    command_ = {};
    for (int i = 0; i < 5; ++i) one_step();
  }

  bool blind = false;              ///< its frames are dropped
  bool dark = false;               ///< they show nothing
  std::optional<Pose2> elsewhere;  ///< they show what is seen from there
  /// Changes what a sample shows to what other sensors see; none: it sees marks.
  std::function<void(agents::Sample&, const Pose2& world_from_robot)> looks;
  std::map<std::string, int> refusals;

 private:
  MarksRobot body_;
  std::unique_ptr<agents::Navigator> navigator_;
  agents::Twist command_;
};

/// Makes a path of poses every 0.2 m (0.13 rad) along straights and arcs.
class Course {
 public:
  explicit Course(const Pose2& start) { poses.push_back(start); }
  Course& straight(double metres) { return arc(metres, 0.0); }
  /// Adds an arc, to the left for positive turns.
  Course& turn(double radius_m, double radians) { return arc(radius_m * std::abs(radians), radians); }
  /// Returns the same path, moved by `metres` to the left.
  std::vector<Pose2> beside(double metres) const {
    std::vector<Pose2> moved;
    for (const Pose2& pose : poses) moved.push_back(pose * Pose2{0.0, metres, 0.0});
    return moved;
  }
  std::vector<Pose2> poses;

 private:
  Course& arc(double metres, double radians) {
    const int steps = std::max(
        {1, static_cast<int>(std::ceil(metres / 0.2)), static_cast<int>(std::ceil(std::abs(radians) / 0.13))});
    for (int i = 0; i < steps; ++i) poses.push_back(poses.back() * se2_exp({metres / steps, 0.0, radians / steps}));
    return *this;
  }
};

inline double distance(const Pose2& a, const Pose2& b) {
  return (a.translation() - b.translation()).norm();
}
inline double turned(const Pose2& a, const Pose2& b) {
  return std::abs(wrap_angle(a.heading - b.heading));
}
/// Returns the distance of a point to a chain of poses that are joined by straight lines.
inline double distance_to(const std::vector<Pose2>& path, const Pose2& pose) {
  double best = 1e9;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Eigen::Vector2d a = path[i].translation();
    const Eigen::Vector2d chord = path[i + 1].translation() - a;
    const double share = std::clamp((pose.translation() - a).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    best = std::min(best, (pose.translation() - a - share * chord).norm());
  }
  return best;
}

}  // namespace weft::test
