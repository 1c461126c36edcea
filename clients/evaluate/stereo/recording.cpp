#include "clients/evaluate/stereo/recording.hpp"

#include <charconv>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "agents/bodies/replay/kitti.hpp"
#include "agents/bodies/replay/recorded_sensors.hpp"
#include "agents/bodies/replay/replay_body.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/recorded_truth.hpp"
#include "clients/evaluate/registration/cloud_file.hpp"

namespace weft::evaluate::stereo {
namespace {

namespace fs = std::filesystem;
using agents::replay::RecordedSensor;

bool is_kitti(const fs::path& folder) {
  return agents::replay::is_kitti(folder.string());
}

/// Returns the names of both cameras, and where the left one is on the robot; KITTI's robot is the left camera.
agents::replay::WantedSensors wanted(const fs::path& folder, const std::function<void(const std::string&)>& warn) {
  if (is_kitti(folder)) return {folder.string(), "image_l+image_r", Pose3{}, warn};
  return {folder.string(), "cam0+cam1", std::nullopt, warn};
}

/// Reads a pose a row, the first of image 0, and gives them the times of the images.
Result<formats::Trajectory> kitti_truth(const fs::path& file, const RecordedSensor& sensor) {
  const Result<std::string> text = read_text(file, "file of poses");
  if (!text) return fail(text.error());
  std::vector<Pose3> poses;
  std::istringstream rows(*text);
  for (std::string row; std::getline(rows, row);) {
    const Result<Pose3> pose =
        registration::parse_matrix(row, file.string() + ":" + std::to_string(poses.size() + 1));
    if (!pose) return fail(pose.error());
    poses.push_back(*pose);
  }
  formats::Trajectory truth;
  for (const agents::replay::Shot& shot : sensor.shots) {
    const std::string name = fs::path(shot.left.empty() ? shot.right : shot.left).stem().string();
    std::size_t number = 0;
    std::from_chars(name.data(), name.data() + name.size(), number);  // the reader has checked it
    if (number >= poses.size())
      return fail(ErrorCode::invalid, file.string() + ": has " + std::to_string(poses.size()) +
                                          " poses and none for image " + name + "; a row for each image is wanted");
    truth.samples.push_back({seconds(shot.time.time_since_epoch()), poses[number]});
  }
  return truth;
}

Result<formats::Trajectory> truth_of(const fs::path& folder, const fs::path& given, const RecordedSensor& sensor) {
  if (is_kitti(folder)) return kitti_truth(given.empty() ? folder / "poses.txt" : given, sensor);
  Result<std::optional<formats::Trajectory>> truth = recorded_truth(folder, given);
  if (!truth) return fail(truth.error());
  if (!*truth)
    return fail(ErrorCode::not_found, folder.string() +
                                          ": says nowhere where the camera truly was; add groundtruth_tum.txt or "
                                          "mav0/state_groundtruth_estimate0/data.csv, or name a file with --truth");
  return std::move(**truth);
}

}  // namespace

Result<Recording> read_recording(const fs::path& folder, const fs::path& truth,
                                 const std::function<void(const std::string&)>& warn) {
  if (!fs::is_directory(folder)) return fail(ErrorCode::not_found, folder.string() + ": no such folder");
  if (!fs::is_directory(folder / "mav0") && !is_kitti(folder))
    return fail(ErrorCode::not_found, folder.string() +
                                          ": no recording of a pair; EuRoC's have mav0/cam0 and mav0/cam1, KITTI's "
                                          "calib.txt, image_l and image_r");
  Result<std::vector<RecordedSensor>> sensors = agents::replay::read_sensors(wanted(folder, warn));
  if (!sensors) return fail(sensors.error());
  const RecordedSensor& pair = sensors->front();
  if (pair.shots.size() < kFewestPairs || pair.shots.size() > kMostPairs)
    return fail(ErrorCode::invalid, folder.string() + ": has " + std::to_string(pair.shots.size()) +
                                        " pairs; must be between " + std::to_string(kFewestPairs) + " and " +
                                        std::to_string(kMostPairs));
  Result<formats::Trajectory> poses = truth_of(folder, truth, pair);
  if (!poses) return fail(poses.error());
  const fs::path normal = fs::absolute(folder / "x").lexically_normal().parent_path();
  return Recording{folder, normal.filename().string(), pair.sensor, pair.shots.size(), std::move(*poses)};
}

Result<std::unique_ptr<agents::Body>> play(const Recording& recording,
                                           const std::function<void(const std::string&)>& warn) {
  const agents::replay::WantedSensors sensors = wanted(recording.folder, warn);
  return agents::replay::make_replay_body({sensors.folder, sensors.names, sensors.robot_from_camera, warn});
}

}  // namespace weft::evaluate::stereo
