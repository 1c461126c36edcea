#include "clients/evaluate/ceiling/frames/frames_score.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "clients/evaluate/ceiling/frames/compared.hpp"

namespace weft::evaluate::ceiling {
namespace {

using namespace agents;

constexpr double kDegrees = 180.0 / std::numbers::pi;

double tilt_deg_of(const CameraModel& camera) {
  const Eigen::Vector3d axis = camera.robot_from_camera.rotation * Eigen::Vector3d::UnitZ();
  return kDegrees * std::acos(std::clamp(axis.z(), -1.0, 1.0));
}

/// Relates all pairs of frames that are places. Returns false when it was stopped.
Result<bool> relate_all(const Recording& recording, const Tracked& tracked, const CameraModel& camera,
                        const std::function<bool()>& asked_to_stop, FramesScore& score) {
  CeilingConfig config;
  config.height_m = camera.robot_from_camera.translation.z() + recording.away_m;
  const Result<Ceiling> method = Ceiling::make(config, camera);
  if (!method) return fail(method.error());
  const std::vector<Pose2> golden = laid_in_a(tracked.start_from_robot, recording.golden_from_camera);
  for (std::size_t a = 0; a < golden.size(); ++a) {
    if (asked_to_stop()) return false;
    for (std::size_t b = a + 1; b < golden.size(); ++b) {
      if (!tracked.contents[a] || !tracked.contents[b]) continue;
      ++score.pairs;
      const OrRefusal<Related> related = method->relate(*tracked.contents[a], *tracked.contents[b], std::nullopt);
      if (!related) {
        ++score.refused[std::string(related.error().reason)];
        continue;
      }
      ++score.accepted_pairs;
      const bool is_wrong = is_off(planar(related->a_from_b), golden[a].inverse() * golden[b],
                                   kWrongHeights * recording.away_m, kWrongDeg / kDegrees);
      if (is_wrong) ++score.wrong_pairs;
    }
  }
  return true;
}

}  // namespace

FramesScore score_of(const Recording& recording, const Tracked& tracked, const CameraModel& camera) {
  const std::vector<Pose2>& ours = tracked.start_from_robot;
  const std::vector<Pose2>& golden = recording.golden_from_camera;
  FramesScore score;
  score.frames = ours.size();
  score.lost = tracked.lost;
  score.rms_heights = aligned(golden, ours).rms_m / recording.away_m;
  score.rms_fitted_heights = aligned_with_scale(golden, ours).rms_m / recording.away_m;
  score.yaw_deg = kDegrees * heading_rms_rad(ours, laid_in_a(ours, golden));
  score.tilt_deg = tilt_deg_of(camera);
  return score;
}

Result<std::optional<FramesScore>> measure_frames(const Recording& recording,
                                                  const std::function<bool()>& asked_to_stop) {
  const Result<CameraModel> camera = mounted(recording);
  if (!camera) return fail(camera.error());
  const Result<std::optional<Tracked>> tracked = track(recording, *camera, asked_to_stop);
  if (!tracked) return fail(tracked.error());
  if (!*tracked) return std::optional<FramesScore>();
  FramesScore score = score_of(recording, **tracked, *camera);
  const Result<bool> related = relate_all(recording, **tracked, *camera, asked_to_stop, score);
  if (!related) return fail(related.error());
  if (!*related) return std::optional<FramesScore>();
  return std::optional(std::move(score));
}

}  // namespace weft::evaluate::ceiling
