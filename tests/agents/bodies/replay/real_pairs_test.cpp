// Real stereo recordings as they are laid out, where they are there: WEFT_DATA names the folder that holds them.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "agents/bodies/replay/replay_body.hpp"

namespace weft::agents::replay {
namespace {

namespace fs = std::filesystem;

class RealPairs : public testing::Test {
 protected:
  Result<std::unique_ptr<Body>> open(const fs::path& recording, const std::string& sensors,
                                     const std::optional<Pose3>& mount = {}) {
    const char* named = std::getenv("WEFT_DATA");
    const fs::path folder = fs::path(named != nullptr ? named : WEFT_DATA_BESIDE) / recording;
    if (!fs::exists(folder)) return fail(ErrorCode::not_found, "no recording at " + folder.string());
    return make_replay_body({folder.string(), sensors, mount, [this](const std::string& text) { warnings += text; }});
  }
  static int pairs_of(Body& body) {
    int pairs = 0;
    for (auto sample = body.step({}); sample; sample = body.step({}))
      for (const View& view : sample->views) pairs += std::holds_alternative<StereoPair>(view.data) ? 1 : 0;
    return pairs;
  }
  std::string warnings;
};

TEST_F(RealPairs, OfEurocAreElevenCentimetresWide) {
  const auto body = open("euroc-mh01-600", "cam0+cam1");
  if (!body) GTEST_SKIP() << "SKIPPED: " << body.error().message << "; set WEFT_DATA to the folder that holds it";
  const Sensor pair = (*body)->rig().sensors.front();
  const Pose3 left_from_right = pair.camera.robot_from_camera.inverse() * pair.right->robot_from_camera;
  EXPECT_NEAR(left_from_right.translation.norm(), 0.110, 0.001);
  EXPECT_EQ(pairs_of(**body), 112);
  EXPECT_EQ(warnings, "");
}

TEST_F(RealPairs, OfKittiAreFiftyFourCentimetresWide) {
  const auto body =
      open("kitti-stereo-2x51/KITTI_sequence_1", "image_l+image_r", downward_mount(0.3, 0.0, 1.65, 0.0, 0.0, 0.0));
  if (!body) GTEST_SKIP() << "SKIPPED: " << body.error().message << "; set WEFT_DATA to the folder that holds it";
  const Sensor pair = (*body)->rig().sensors.front();
  EXPECT_NEAR((pair.camera.robot_from_camera.inverse() * pair.right->robot_from_camera).translation.x(), 0.537,
              0.001);
  EXPECT_EQ(pairs_of(**body), 51);
  EXPECT_THAT(warnings, testing::HasSubstr("ten images a second"));
}

}  // namespace
}  // namespace weft::agents::replay
