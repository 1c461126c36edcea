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

/// Has a hand drive the body along the line, once, and remembers what it saw. None: it was stopped.
Result<std::optional<std::vector<Sample>>> drive_once(const Drive& drive, const std::vector<SitePoint>& line) {
  std::error_code ignored;  // a file that cannot be removed cannot be appended to either, which is told
  std::filesystem::remove(drive.body.truth_path.value_or(""), ignored);
  const Result<std::unique_ptr<Body>> body = sim::make_sim_body(drive.body);
  if (!body) return fail(body.error());
  if (const Result<void> led = (*body)->drive_by_hand(line); !led) return fail(led.error());
  std::vector<Sample> samples;
  while (samples.empty() || !samples.back().hand_done) {
    if (drive.asked_to_stop()) return std::optional<std::vector<Sample>>();
    Result<Sample> sample = (*body)->step({});
    if (!sample) return fail(sample.error());
    samples.push_back(std::move(*sample));
  }
  return std::optional(std::move(samples));
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

Result<std::optional<MountDrive>> mount_by_hand(const Drive& drive, const std::vector<SitePoint>& line,
                                                const FindMount& find, MountDriveConfig config) {
  const RemovedAtEnd truth(drive.body.truth_path.value_or(""));
  const Result<std::unique_ptr<Body>> body = sim::make_sim_body(drive.body);
  if (!body) return fail(body.error());
  const CameraModel given = (*body)->rig().camera();
  const auto samples = drive_once(drive, line);
  if (!samples) return fail(samples.error());
  if (!*samples) return std::optional<MountDrive>();
  const Result<double> measured = measured_m(drive);
  if (!measured) return fail(measured.error());

  config.distance_m = *measured;
  config.distance_sigma_m = kTapeSigmaM;
  bool is_stopped = false;
  const PlayDrive again = [&](const std::function<void(const View*, const Motion&)>& take) -> Result<void> {
    for (const Sample& sample : **samples) {
      is_stopped = is_stopped || drive.asked_to_stop();
      if (is_stopped) return fail(ErrorCode::refused, "stopped");
      take(sample.of({}), sample.motion);
    }
    return {};
  };
  Result<MountDrive> found = find(given, again, config);
  if (is_stopped) return std::optional<MountDrive>();
  if (!found) return fail(found.error());
  return std::optional(std::move(*found));
}

Result<std::optional<CameraModel>> calibrated(const Drive& drive, const std::vector<SitePoint>& line) {
  const Result<std::optional<MountDrive>> found = mount_by_hand(drive, line, calibrate_floor_mount, {});
  if (!found) return fail(found.error());
  return *found ? std::optional((*found)->camera) : std::optional<CameraModel>();
}

}  // namespace weft::evaluate::floor
