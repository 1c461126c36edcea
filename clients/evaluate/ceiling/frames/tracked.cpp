#include "clients/evaluate/ceiling/frames/tracked.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "agents/methods/ceiling/ceiling.hpp"
#include "agents/perception/mount.hpp"
#include "clients/evaluate/ceiling/frames/tilt.hpp"

namespace weft::evaluate::ceiling {
namespace {

using namespace agents;

constexpr std::chrono::milliseconds kBetweenFrames{100};  // not recorded; only the command has a use for it

Result<Ceiling> method_of(const Recording& recording, const CameraModel& camera) {
  CeilingConfig config;
  config.height_m = camera.robot_from_camera.translation.z() + recording.away_m;
  return Ceiling::make(config, camera);
}

/// Returns 1 sigma of a tilt, by how far those of each other pair of views lie apart; none where these are few.
std::optional<double> tilt_sigma_of(const Recording& recording, const std::vector<SeenTwice>& pairs) {
  std::array<std::vector<SeenTwice>, 2> halves;
  for (std::size_t i = 0; i < pairs.size(); ++i) halves[i % 2].push_back(pairs[i]);
  const std::optional<FoundTilt> one = find_tilt(recording.camera, halves[0], recording.away_m);
  const std::optional<FoundTilt> other = find_tilt(recording.camera, halves[1], recording.away_m);
  if (!one || !other) return std::nullopt;
  return 0.5 * std::hypot(one->pitch_rad - other->pitch_rad, one->roll_rad - other->roll_rad);
}

}  // namespace

Result<CameraModel> mounted(const Recording& recording) {
  constexpr double apart_rad = 0.08;
  const std::vector<SeenTwice> pairs = seen_twice(recording.camera, recording.frames, apart_rad);
  const std::optional<FoundTilt> tilt = find_tilt(recording.camera, pairs, recording.away_m);
  if (!tilt)
    return fail(ErrorCode::refused, "the recorded frames show only " + std::to_string(pairs.size()) +
                                        " pairs of views that are apart; 3 are wanted to see how the camera leans");
  CameraModel camera = tilted(recording.camera, tilt->pitch_rad, tilt->roll_rad);
  const Eigen::Vector2d ahead = travelled(camera, pairs, recording.away_m);
  const Pose2 robot_from_mount{0.0, 0.0, -std::atan2(ahead.y(), ahead.x())};
  camera.robot_from_camera = lift(robot_from_mount) * camera.robot_from_camera;
  camera.sigma.tilt_rad = tilt_sigma_of(recording, pairs);
  return camera;
}

Result<std::optional<Tracked>> track(const Recording& recording, const CameraModel& camera,
                                     const std::function<bool()>& asked_to_stop) {
  const Result<Ceiling> method = method_of(recording, camera);
  if (!method) return fail(method.error());
  Tracked tracked;
  Ceiling::Odometry odometry;
  Motion motion;
  motion.elapsed = kBetweenFrames;
  Pose2 start_from_robot;
  for (const Image& frame : recording.frames) {
    if (asked_to_stop()) return std::optional<Tracked>();
    View view;
    view.frame = tracked.start_from_robot.size() + 1;
    view.time = SensorTime(view.frame * kBetweenFrames);
    view.sensor = camera.id;
    view.data = frame;
    const Step step = method->observe(odometry, &view, motion);
    const Pose2 moved = planar(step.previous_from_current);
    const double elapsed_s = seconds(motion.elapsed);
    motion.command = {moved.x / elapsed_s, moved.heading / elapsed_s};
    if (!step.seen && !tracked.start_from_robot.empty()) ++tracked.lost;
    start_from_robot = start_from_robot * moved;
    tracked.start_from_robot.push_back(start_from_robot);
    OrRefusal<CeilingContent> content = method->extract(odometry, view);
    tracked.contents.push_back(content ? std::optional(std::move(*content)) : std::nullopt);
  }
  return std::optional(std::move(tracked));
}

}  // namespace weft::evaluate::ceiling
