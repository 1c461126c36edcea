#pragma once
// Writes a short drive through a room as recordings are laid out, with its truth.
#include <filesystem>
#include <fstream>
#include <string>

#include "agents/perception/camera_model.hpp"
#include "storage/formats/trajectory.hpp"
#include "tests/support/raw_png.hpp"
#include "tests/support/stereo_room.hpp"

namespace weft::evaluate::stereo::test {

inline constexpr int kPairs = 9;
inline constexpr std::int64_t kBeganNs = 1'400'000'000'000'000'000;
inline constexpr std::int64_t kApartNs = 100'000'000;

inline agents::Sensor small_sensor() {
  return weft::test::stereo_sensor(240, 180, 156.0, 0.12);
}

inline Pose3 room_from_robot(int pair) {
  Pose2 at{1.0, 0.0, -0.1};
  for (int i = 0; i < pair; ++i) at = at * se2_exp({0.04, 0.004, 0.02});
  return lift(at);
}

inline void write_text(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

inline void write_image(const std::filesystem::path& file, const agents::Image& image) {
  std::filesystem::create_directories(file.parent_path());
  weft::test::write_png(file, {images::Shades::grey, image.width, image.height, *image.pixels});
}

/// Writes mav0 with both cameras, and groundtruth_tum.txt.
inline void write_euroc(const std::filesystem::path& folder) {
  const agents::Sensor sensor = small_sensor();
  const weft::test::StereoRoom room = weft::test::crate_room();
  std::string list = "#timestamp [ns],filename\n";
  formats::Trajectory truth;
  for (int i = 0; i < kPairs; ++i) {
    weft::test::StereoShot shot;
    shot.seed = static_cast<std::uint64_t>(i + 1);
    const agents::StereoPair pair = room.pair(sensor, room_from_robot(i), shot);
    const std::string time = std::to_string(kBeganNs + i * kApartNs);
    write_image(folder / "mav0/cam0/data" / (time + ".png"), pair.left);
    write_image(folder / "mav0/cam1/data" / (time + ".png"), pair.right);
    list += time + "," + time + ".png\n";
    truth.samples.push_back({1e-9 * static_cast<double>(kBeganNs + i * kApartNs), room_from_robot(i)});
  }
  for (const auto& [name, camera] : {std::pair{"cam0", sensor.camera}, {"cam1", *sensor.right}}) {
    write_text(folder / "mav0" / name / "data.csv", list);
    write_text(folder / "mav0" / name / "sensor.yaml", camera_file_text(calibration_from(camera), {}));
  }
  write_text(folder / "groundtruth_tum.txt", formats::tum_text(truth));
}

/// Returns the rows of a file of poses, as KITTI has them: where the left camera is.
inline std::string kitti_poses(int pairs) {
  std::string text;
  for (int i = 0; i < pairs; ++i) {
    const Pose3 pose = room_from_robot(i) * small_sensor().camera.robot_from_camera;
    Eigen::Matrix<double, 3, 4> rows;
    rows << pose.rotation.toRotationMatrix(), pose.translation;
    for (int r = 0; r < 3; ++r)
      for (int c = 0; c < 4; ++c) text += std::to_string(rows(r, c)) + (r == 2 && c == 3 ? "\n" : " ");
  }
  return text;
}

/// Lays the same drive out as KITTI's, of the images that write_euroc has written.
inline void write_kitti(const std::filesystem::path& folder, const std::filesystem::path& euroc) {
  const agents::CameraModel camera = small_sensor().camera;
  const auto projection = [&](double shift) {
    return std::to_string(camera.fx) + " 0 " + std::to_string(camera.cx) + " " + std::to_string(shift) + " 0 " +
           std::to_string(camera.fx) + " " + std::to_string(camera.cy) + " 0 0 0 1 0\n";
  };
  write_text(folder / "calib.txt", projection(0.0) + projection(-0.12 * camera.fx));
  write_text(folder / "poses.txt", kitti_poses(kPairs));
  for (int i = 0; i < kPairs; ++i) {
    const std::string from = std::to_string(kBeganNs + i * kApartNs) + ".png";
    for (const auto& [half, name] : {std::pair{"image_l", "cam0"}, {"image_r", "cam1"}}) {
      std::filesystem::create_directories(folder / half);
      std::filesystem::copy_file(euroc / "mav0" / name / "data" / from,
                                 folder / half / ("00000" + std::to_string(i) + ".png"));
    }
  }
}

}  // namespace weft::evaluate::stereo::test
