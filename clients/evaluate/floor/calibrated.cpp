#include "clients/evaluate/floor/calibrated.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <system_error>
#include <utility>

#include "agents/methods/floor/mount_drive.hpp"
#include "clients/evaluate/truth.hpp"
#include "core/random.hpp"

namespace weft::evaluate::floor {
namespace {

using namespace agents;

constexpr double kTapeSigmaM = 0.002;

/// Removes a file at the end of its scope, however that ends.
struct RemovedAtEnd {
  explicit RemovedAtEnd(std::filesystem::path of) : file(std::move(of)) {}
  RemovedAtEnd(const RemovedAtEnd&) = delete;
  RemovedAtEnd& operator=(const RemovedAtEnd&) = delete;
  ~RemovedAtEnd() {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
  }
  std::filesystem::path file;
};

using Take = std::function<void(const View*, const Motion&)>;

/// Has a hand drive the body along the line, and hands on each sample. Returns false when it was stopped.
Result<bool> play(const Drive& drive, const std::vector<SitePoint>& line, const Take& take) {
  std::error_code ignored;  // a file that cannot be removed cannot be appended to either, which is told
  std::filesystem::remove(drive.body.truth_path.value_or(""), ignored);
  const Result<std::unique_ptr<Body>> body = sim::make_sim_body(drive.body);
  if (!body) return fail(body.error());
  if (const Result<void> led = (*body)->drive_by_hand(line); !led) return fail(led.error());
  for (bool done = false; !done;) {
    if (drive.asked_to_stop()) return false;
    const Result<Sample> sample = (*body)->step({});
    if (!sample) return fail(sample.error());
    take(sample->of({}), sample->motion);
    done = sample->hand_done;
  }
  return true;
}

/// Measures, as with a tape, from where the robot stood first to where it stood last.
Result<double> measured_m(const Drive& drive) {
  const std::filesystem::path file = drive.body.truth_path.value_or("");
  const auto truth = read_truth(file);
  if (!truth) return fail(truth.error());
  if (truth->empty()) return fail(ErrorCode::refused, "the drive to calibrate with is empty: give a longer line");
  const Pose2& first = truth->begin()->second.site_from_robot;
  const Pose2& last = truth->rbegin()->second.site_from_robot;
  Random tape(drive.body.seed);
  return (first.inverse() * last).translation().norm() + kTapeSigmaM * tape.normal();
}

}  // namespace

Result<std::optional<agents::CameraModel>> calibrated(const Drive& drive, const std::vector<SitePoint>& line) {
  const RemovedAtEnd truth(drive.body.truth_path.value_or(""));
  const Result<bool> driven = play(drive, line, [](const View*, const Motion&) {});
  if (!driven) return fail(driven.error());
  if (!*driven) return std::optional<agents::CameraModel>();
  const Result<double> measured = measured_m(drive);
  if (!measured) return fail(measured.error());

  MountDriveConfig config;
  config.distance_m = *measured;
  config.distance_sigma_m = kTapeSigmaM;
  bool is_stopped = false;
  Drive unseen = drive;
  unseen.body.truth_path.reset();
  const Result<std::unique_ptr<Body>> body = sim::make_sim_body(unseen.body);
  if (!body) return fail(body.error());
  const PlayDrive again = [&](const Take& take) -> Result<void> {
    const Result<bool> played = play(unseen, line, take);
    if (!played) return fail(played.error());
    is_stopped = !*played;
    return is_stopped ? Result<void>(fail(ErrorCode::refused, "stopped")) : Result<void>();
  };
  const Result<MountDrive> found = calibrate_floor_mount((*body)->rig().camera(), again, config);
  if (is_stopped) return std::optional<agents::CameraModel>();
  if (!found) return fail(found.error());
  return std::optional(found->camera);
}

}  // namespace weft::evaluate::floor
