// Against OpenCV's chessboards, where they are: WEFT_DATA names the folder that holds opencv-samples.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>

#include "agents/perception/calibration/camera_fit.hpp"
#include "images/read.hpp"

namespace weft::agents {
namespace {

namespace fs = std::filesystem;

TEST(RealBoards, TheLeftCameraIsAsOpenCvFoundIt) {
  const char* named = std::getenv("WEFT_DATA");
  const fs::path data = fs::path(named != nullptr ? named : WEFT_DATA_BESIDE) / "opencv-samples";
  if (!fs::exists(data))
    GTEST_SKIP() << "SKIPPED: no chessboards at " << data << "; set WEFT_DATA to the folder that holds them";
  std::vector<BoardImage> images;
  for (int i = 1; i <= 14; ++i) {
    if (i == 10) continue;
    const std::string name = std::string("left") + (i < 10 ? "0" : "") + std::to_string(i) + ".jpg";
    auto grey = images::read(data / name, images::Shades::grey);
    ASSERT_TRUE(grey) << grey.error().message;
    auto pixels = std::make_shared<Bytes>(std::move(grey->samples));
    if (const auto found = find_board({grey->width, grey->height, pixels}, ChessBoard{9, 6, 0.025}))
      images.push_back({name, *found});
  }
  EXPECT_EQ(images.size(), 13U);
  const auto fit = fit_camera(images, 640, 480, {});
  ASSERT_TRUE(fit) << fit.error().message;
  // left_intrinsics.yml beside the images: with k3, one focal length, and an image that we leave out.
  EXPECT_NEAR(fit->camera.fx, 535.9, 6.0);
  EXPECT_NEAR(fit->camera.cx, 342.3, 4.0);
  EXPECT_NEAR(fit->camera.cy, 235.6, 4.0);
  EXPECT_NEAR(fit->camera.distortion[0], -0.266, 0.06);
  EXPECT_LT(fit->rms_px, 0.5);
}

}  // namespace
}  // namespace weft::agents
