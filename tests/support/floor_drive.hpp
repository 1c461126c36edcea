#pragma once
// Drives a robot with the method `floor` over a test floor and says how its odometry did.
#include <map>
#include <string>

#include "agents/methods/advance.hpp"
#include "agents/methods/floor/floor.hpp"
#include "tests/support/flat_floor.hpp"

namespace weft::test {

struct Drive {
  double speed_m_s = 0.6;
  double turn_rad_s = 0.0;
  double duration_s = 5.0;
  double frames_per_second = 30.0;
  double vibration = 1.0;      ///< times 0.05 degrees and 1 mm
  double rocks_about_m = 0.0;  ///< above the floor
  bool wheels = true;          ///< 3 % long, 2 % too much turn
  bool blur = false;           ///< 5 ms of open shutter; renders three times as much
  double drop_share = 0.0;     ///< of the frames
  Pose2 start{1.2, 2.0, 0.0};
  Shot shot;  ///< seed and blur are set for each frame
  std::uint64_t seed = 1;
};

struct Driven {
  Pose2 true_motion;
  Pose2 seen_motion;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double length_m = 0.0;
  int blind = 0;            ///< without the first view
  double step_off_m = 0.0;  ///< RMS over steps, from the 60th on
  std::map<std::string, int, std::less<>> reasons;
  agents::Floor::Odometry odometry;

  /// Returns the error of the distance seen as a share of the true distance, signed.
  double distance_error() const { return seen_motion.translation().norm() / true_motion.translation().norm() - 1.0; }
  double heading_error_deg_per_m() const {
    return std::abs(wrap_angle(seen_motion.heading - true_motion.heading)) * 180.0 / M_PI / length_m;
  }
  double off_m() const { return (true_motion.inverse() * seen_motion).translation().norm(); }
};

inline Driven drive(const agents::Floor& method, const FloorCamera& eye, const FlatFloor& floor, const Drive& how) {
  Driven out;
  Random random(how.seed * 31U + 7U);
  const Vibration vibration(how.seed, how.vibration * 0.05 * M_PI / 180.0, how.vibration * 0.001);
  const double dt = 1.0 / how.frames_per_second;
  const Pose2 step = se2_exp({how.speed_m_s * dt, 0.0, how.turn_rad_s * dt});
  Relation start_from_robot = Metric2{};
  agents::CommonErrors common = agents::CommonErrors::Zero();
  Pose2 floor_from_robot = how.start;
  const int frames = static_cast<int>(how.duration_s * how.frames_per_second);
  double squares = 0.0;
  for (int i = 0; i <= frames; ++i) {
    agents::Motion motion;
    if (i > 0) {
      floor_from_robot = floor_from_robot * step;
      out.length_m += std::abs(how.speed_m_s) * dt;
      motion.elapsed = from_seconds(dt);
      motion.command = {how.speed_m_s, how.turn_rad_s};
    }
    if (how.wheels)
      motion.wheels =
          agents::WheelStep{1.03 * motion.command.linear_m_s * dt, 1.02 * motion.command.angular_rad_s * dt};
    Shot shot = how.shot;
    shot.seed = how.seed * 100003U + static_cast<std::uint64_t>(i);
    if (how.blur) shot.blur = se2_exp({how.speed_m_s * 0.005, 0.0, how.turn_rad_s * 0.005});
    agents::View view;
    view.frame = static_cast<std::uint64_t>(i);
    const bool dropped = i > 0 && i < frames && random.chance(how.drop_share);
    const agents::Attitude attitude = vibration.at(i * dt);
    // The camera goes where one that rocks about the floor would have gone from here.
    const Pose2 as_if_from_floor =
        floor_from_robot * Pose2{-how.rocks_about_m * attitude.pitch_rad, how.rocks_about_m * attitude.roll_rad, 0.0};
    if (!dropped) view.data = eye.render(floor, as_if_from_floor, attitude, shot);
    const agents::Step seen = method.observe(out.odometry, dropped ? nullptr : &view, motion);
    if (i > 0 && !seen.seen) {
      ++out.blind;
      ++out.reasons[std::string(seen.blind_reason)];
    }
    start_from_robot = agents::advanced(start_from_robot, seen, common);
    if (i >= 60) squares += (step.inverse() * planar(seen.previous_from_current)).translation().squaredNorm();
  }
  out.step_off_m = std::sqrt(squares / std::max(1, frames - 59));
  out.true_motion = how.start.inverse() * floor_from_robot;
  out.seen_motion = planar(start_from_robot);
  out.covariance = planar_covariance(start_from_robot);
  return out;
}

/// Renders a view of the floor from a pose, and returns the content that the method keeps of it.
inline agents::OrRefusal<agents::FloorContent> look(const agents::Floor& method, const FloorCamera& eye,
                                                    const FlatFloor& floor, const Pose2& floor_from_robot,
                                                    const agents::Attitude& attitude, const Shot& shot) {
  agents::View view;
  view.data = eye.render(floor, floor_from_robot, attitude, shot);
  return method.extract({}, view);
}

}  // namespace weft::test
