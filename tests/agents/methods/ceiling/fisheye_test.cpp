// A fisheye that leans by 20 degrees under a bare grid of lamps, all else black: as the real recording.
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "agents/methods/ceiling/ceiling.hpp"
#include "agents/perception/mount.hpp"
#include "tests/agents/methods/ceiling/rendered_ceiling.hpp"

namespace weft::agents {
namespace {

constexpr double kAboveM = 2.6;

CameraModel leaning_fisheye() {
  CameraModel camera = test::up_camera(0.0, 0.0, 0.1);
  camera.lens = LensModel::equidistant;
  camera.distortion = {0.015, 0.0, 0.0, 0.0, 0.0};
  camera.fx = camera.fy = 189.0;
  return tilted(camera, 0.02, 0.36);
}

/// Returns lamps of 0.25 by 1.2 m, one in each 3.05 by 3.66 m.
test::RenderedCeiling lamps() {
  test::Panel panel{kAboveM, test::box(-20.0, -20.0, 40.0, 40.0)};
  panel.px_m = 0.02;
  panel.columns = 2000;
  panel.greys.assign(2000 * 2000, 0);
  for (int row = 0; row < 2000; ++row)
    for (int column = 0; column < 2000; ++column)
      if (std::fmod(0.02 * column, 3.05) < 0.25 && std::fmod(0.02 * row, 3.66) < 1.2)
        panel.greys[static_cast<std::size_t>(2000 * row + column)] = 255;
  test::RenderedCeiling ceiling;
  ceiling.panels.push_back(panel);
  ceiling.beside_grey = 0.0;
  return ceiling;
}

View in_black_and_white(View view) {
  Image image = std::get<Image>(view.data);
  auto pixels = std::make_shared<Bytes>(*image.pixels);
  for (std::uint8_t& grey : *pixels) grey = grey < 128 ? 0 : 255;
  image.pixels = std::move(pixels);
  view.data = std::move(image);
  return view;
}

TEST(CeilingFisheye, FollowsABareGridOfLampsAndItsScale) {
  const CameraModel camera = leaning_fisheye();
  CeilingConfig config;
  config.height_m = kAboveM;
  const Ceiling method = *Ceiling::make(config, camera);
  test::RenderedCeiling ceiling = lamps();
  Ceiling::Odometry odometry;
  Motion motion;
  motion.elapsed = std::chrono::milliseconds(100);
  Random random(11);
  Pose2 truth;
  Pose2 seen;
  std::map<std::string, int> blind;
  constexpr int frames = 40;
  for (int i = 0; i < frames; ++i) {
    const double step_m = 0.09 + 0.03 * std::sin(0.7 * i);
    const double turn = 0.02 * std::sin(0.2 * i);
    if (i > 0) truth = truth * se2_exp({step_m, 0.0, turn});
    const Attitude sway{random.normal(0.0, 0.0009), random.normal(0.0, 0.0009), 0.0};
    const View view = in_black_and_white(ceiling.view(camera, truth, sway, static_cast<std::uint64_t>(i) + 1));
    const Step step = method.observe(odometry, &view, motion);
    if (!step.seen) ++blind[std::string(step.blind_reason)];
    const Pose2 moved = planar(step.previous_from_current);
    seen = seen * moved;
    motion.command = {10.0 * moved.x, 10.0 * moved.heading};
  }
  EXPECT_EQ(blind, (std::map<std::string, int>{{"first_view", 1}}));
  EXPECT_LT((seen.translation() - truth.translation()).norm(), 0.03 * truth.translation().norm())
      << seen.x << " " << seen.y << " for " << truth.x << " " << truth.y;
  EXPECT_NEAR(seen.heading, truth.heading, 0.01);
  for (const Ceiling::Tracked& track : odometry.tracks) {
    const Eigen::Vector3d ray = camera.robot_from_camera.rotation * track.in_keyframe.homogeneous().normalized();
    EXPECT_LT(std::atan(track.in_keyframe.norm()), config.off_axis_rad) << "as far as the lens is known";
    EXPECT_LT(std::acos(ray.z()), config.off_vertical_rad) << "and no lower than a ceiling";
  }
}

}  // namespace
}  // namespace weft::agents
