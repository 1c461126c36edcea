#pragma once
#include <cmath>
#include <cstdint>
#include <vector>

#include "agents/perception/motion.hpp"
#include "agents/perception/sample.hpp"
#include "core/geometry/pose2.hpp"
#include "core/random.hpp"
#include "tests/support/marks.hpp"
#include "tests/support/unicycle.hpp"

namespace weft::test {

struct MarksWorldConfig {
  double width_m = 40.0;
  double height_m = 40.0;
  double spacing_m = 0.4;  ///< of a grid on which each mark is moved and turned at random
  double ahead_m = 0.4;    ///< the sensor sees a disc of `sees_m` around this point
  double sees_m = 0.9;
  double position_sigma_m = 0.004;
  double heading_sigma_rad = 0.008;
  double wrong_share = 0.0;  ///< of sightings that bear another mark's number
  double alias_share = 0.0;  ///< of cells whose mark has the number of another cell's
  struct Disc {
    double x, y, radius_m;
  };
  std::vector<Disc> blank;  ///< nothing can be seen here
};

/// Holds a floor of numbered marks, fixed after construction; the site frame's origin is the lower left corner.
class MarksWorld {
 public:
  MarksWorld(const MarksWorldConfig& config, std::uint64_t seed) : config_(config) {
    Random random(seed);
    Random aliases = random.fork(1);  // of its own: positions do not depend on the shares
    columns_ = static_cast<int>(config.width_m / config.spacing_m);
    rows_ = static_cast<int>(config.height_m / config.spacing_m);
    const auto cells = static_cast<std::uint64_t>(columns_) * static_cast<std::uint64_t>(rows_);
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const std::uint64_t own = marks_.size() + 1;
        const std::uint64_t mark = aliases.chance(config.alias_share) ? aliases.below(cells) + 1 : own;
        const Pose2 world_from_mark{(column + random.uniform(0.1, 0.9)) * config.spacing_m,
                                    (row + random.uniform(0.1, 0.9)) * config.spacing_m, random.uniform(-3.1, 3.1)};
        marks_.push_back({mark, world_from_mark});
      }
    }
  }

  /// Returns what a robot sees from there; the noise is drawn from `random`.
  agents::Marks see(const Pose2& world_from_robot, Random& random) const {
    agents::Marks marks;
    for (const auto& disc : config_.blank) {
      if (std::hypot(world_from_robot.x - disc.x, world_from_robot.y - disc.y) < disc.radius_m) return marks;
    }
    const Pose2 robot_from_world = world_from_robot.inverse();
    const Eigen::Vector2d middle = world_from_robot * Eigen::Vector2d(config_.ahead_m, 0.0);
    const auto cell = [&](double metres) { return static_cast<int>(std::floor(metres / config_.spacing_m)); };
    for (int row = cell(middle.y() - config_.sees_m); row <= cell(middle.y() + config_.sees_m); ++row) {
      for (int column = cell(middle.x() - config_.sees_m); column <= cell(middle.x() + config_.sees_m); ++column) {
        if (row < 0 || column < 0 || row >= rows_ || column >= columns_) continue;
        const Mark& mark = marks_[static_cast<std::size_t>(row * columns_ + column)];
        if ((mark.world_from_mark.translation() - middle).norm() > config_.sees_m) continue;
        Pose2 seen = robot_from_world * mark.world_from_mark;
        seen.x += random.normal(0.0, config_.position_sigma_m);
        seen.y += random.normal(0.0, config_.position_sigma_m);
        seen.heading = wrap_angle(seen.heading + random.normal(0.0, config_.heading_sigma_rad));
        const bool wrong = config_.wrong_share > 0.0 && random.chance(config_.wrong_share);
        marks.sightings.push_back({wrong ? random.below(marks_.size()) + 1 : mark.number, seen});
      }
    }
    return marks;
  }

 private:
  struct Mark {
    std::uint64_t number;
    Pose2 world_from_mark;
  };
  MarksWorldConfig config_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Mark> marks_;
};

struct MarksRobotConfig {
  UnicycleConfig base;
  double elapsed_s = 0.1;
  double wheel_scale = 1.02;  ///< of the distance that the wheels report
  double wheel_heading_rad_per_m = 0.01;
  double dropped_share = 0.0;  ///< of views
};

/// Simulates a unicycle on a floor of marks: one view and one step of the wheels a sample.
class MarksRobot {
 public:
  MarksRobot(const MarksWorld& world, const MarksRobotConfig& config, const Pose2& start, std::uint64_t seed)
      : world_(&world), config_(config), base_(config.base, start), random_(seed) {}

  agents::Sample step(const agents::Twist& command) {
    base_.drive(command, config_.elapsed_s);
    ++frame_;
    agents::Sample sample;
    sample.motion.elapsed = from_seconds(config_.elapsed_s);
    sample.motion.command = command;
    const Pose2& moved = base_.last_step();
    const double distance = std::copysign(std::hypot(moved.x, moved.y), moved.x);
    sample.motion.wheels =
        agents::WheelStep{distance * config_.wheel_scale, moved.heading + distance * config_.wheel_heading_rad_per_m};
    sample.frame = frame_;
    sample.time = SensorTime{} + from_seconds(config_.elapsed_s * static_cast<double>(frame_));
    const agents::Marks seen = world_->see(base_.world_from_robot(), random_);
    const bool is_dropped = config_.dropped_share > 0.0 && random_.chance(config_.dropped_share);
    if (!is_dropped) sample.views.push_back({frame_, sample.time, "marks", "marks", seen});
    return sample;
  }

  /// Returns what it would see there.
  agents::Marks look_from(const Pose2& world_from_robot) { return world_->see(world_from_robot, random_); }

  const Pose2& world_from_robot() const { return base_.world_from_robot(); }
  double elapsed_s() const { return config_.elapsed_s; }

 private:
  const MarksWorld* world_;
  MarksRobotConfig config_;
  Unicycle base_;
  Random random_;
  std::uint64_t frame_ = 0;
};

}  // namespace weft::test
