#pragma once
#include <filesystem>
#include <fstream>
#include <string>

#include "agents/bodies/sim/sim_body.hpp"
#include "clients/evaluate/truth.hpp"
#include "storage/formats/trajectory.hpp"
#include "tests/support/raw_png.hpp"

namespace weft::evaluate::floor {

/// Records a simulated robot led along a line, in EuRoC layout with groundtruth_tum.txt beside it.
inline Result<void> record_drive(const agents::sim::SimBodyConfig& given, const std::vector<agents::SitePoint>& line,
                                 const std::filesystem::path& folder) {
  agents::sim::SimBodyConfig config = given;
  const std::filesystem::path camera = folder / "mav0" / "cam0";
  std::filesystem::create_directories(camera / "data");
  config.truth_path = (folder / "truth.jsonl").string();
  auto body = agents::sim::make_sim_body(config);
  if (!body) return fail(body.error());
  if (auto begun = (*body)->drive_by_hand(line); !begun) return begun;

  const agents::CameraModel model = (*body)->rig().camera();
  std::ofstream sensor(camera / "sensor.yaml");
  sensor.precision(12);
  sensor << "camera_model: pinhole\nresolution: [" << model.width << ", " << model.height << "]\nintrinsics: ["
         << model.fx << ", " << model.fy << ", " << model.cx << ", " << model.cy
         << "]\ndistortion_model: radial-tangential\ndistortion_coefficients: [" << model.distortion[0] << ", "
         << model.distortion[1] << ", " << model.distortion[2] << ", " << model.distortion[3]
         << "]\nT_BS:\n  cols: 4\n  rows: 4\n  data: [";
  const Eigen::Matrix3d rotation = model.robot_from_camera.rotation.toRotationMatrix();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) sensor << rotation(row, column) << ", ";
    sensor << model.robot_from_camera.translation[row] << ",\n         ";
  }
  sensor << "0.0, 0.0, 0.0, 1.0]\n";

  std::ofstream list(camera / "data.csv");
  list << "#timestamp [ns],filename\n";
  std::map<std::uint64_t, double> times;
  for (bool done = false; !done;) {
    const auto sample = (*body)->step({});
    if (!sample) return fail(sample.error());
    done = sample->hand_done;
    times[sample->frame] = seconds(sample->time.time_since_epoch());
    const std::string name = std::to_string(sample->frame) + ".png";
    list << sample->time.time_since_epoch().count() << "," << name << "\n";
    if (sample->views.empty()) continue;  // a dropped frame: listed, and missing
    const auto& image = std::get<agents::Image>(sample->views.front().data);
    weft::test::write_png(camera / "data" / name, {images::Shades::grey, image.width, image.height, *image.pixels});
  }
  body->reset();
  const auto truth = read_truth(*config.truth_path);
  if (!truth) return fail(truth.error());
  formats::Trajectory trajectory;
  for (const auto& [frame, moment] : *truth) {
    const Pose2& pose = moment.site_from_robot;
    trajectory.samples.push_back(
        {times.at(frame),
         {Eigen::Quaterniond(Eigen::AngleAxisd(pose.heading, Eigen::Vector3d::UnitZ())), {pose.x, pose.y, 0.0}}});
  }
  std::ofstream(folder / "groundtruth_tum.txt") << formats::tum_text(trajectory);
  return {};
}

}  // namespace weft::evaluate::floor
