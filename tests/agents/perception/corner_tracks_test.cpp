#include "agents/perception/corner_tracks.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "agents/perception/planar_motion.hpp"
#include "tests/support/flat_floor.hpp"

namespace weft::agents {
namespace {

class CornerTracks : public testing::Test {
 protected:
  test::FlatFloor floor_ = test::FlatFloor::procedural(21, 4.0, 3.0);
  CameraModel camera_ = test::paper_camera();
  test::FloorCamera eye_{camera_};
};

TEST_F(CornerTracks, CornersAreSpreadAndWithinTheBorder) {
  const Image image = eye_.render(floor_, {0.8, 1.5, 0.0}, {}, {});
  const auto corners = find_corners(prepare_tracking(image, 13, 3), CornerConfig{});
  EXPECT_EQ(corners.size(), 160U);
  int left = 0;
  int top = 0;
  for (const Eigen::Vector2d& c : corners) {
    EXPECT_GE(c.minCoeff(), 12.0);
    left += c.x() < 376.0 ? 1 : 0;
    top += c.y() < 240.0 ? 1 : 0;
  }
  EXPECT_NEAR(left, 80, 30);
  EXPECT_NEAR(top, 80, 30);
}

TEST_F(CornerTracks, FollowTheFloorToAFractionOfAPixel) {
  PlanarState truth;
  truth.a_from_b = {0.02, 0.002, 0.01};
  test::Shot second;
  second.seed = 2;
  const Pose2 start{0.8, 1.5, 0.2};
  const TrackingImage a = prepare_tracking(eye_.render(floor_, start, {}, {}), 13, 3);
  const TrackingImage b = prepare_tracking(eye_.render(floor_, start * truth.a_from_b, {}, second), 13, 3);
  const auto corners = find_corners(a, CornerConfig{});
  const auto tracks = track_corners(a, b, corners, corners);
  std::vector<double> errors;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Reprojection there = reproject(camera_, camera_, truth, normalised_from_pixel(camera_, corners[i]));
    if (tracks[i].found) errors.push_back((tracks[i].pixel - pixel_from_normalised(camera_, there.in_b)).norm());
  }
  ASSERT_GT(errors.size(), 100U);
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.15);
}

TEST_F(CornerTracks, AnImageIsWholeOrNot) {
  EXPECT_FALSE(is_whole(Image{}));
  EXPECT_FALSE(is_whole({4, 4, std::make_shared<const Bytes>(15)}));
  EXPECT_TRUE(is_whole({4, 4, std::make_shared<const Bytes>(16)}));
}

TEST_F(CornerTracks, APlainFloorHasNoCorners) {
  test::Shot quiet;
  quiet.noise = 0.0;
  const Image image = eye_.render(test::FlatFloor::blank(4.0, 3.0), {0.8, 1.5, 0.0}, {}, quiet);
  EXPECT_TRUE(find_corners(prepare_tracking(image, 13, 3), CornerConfig{}).empty());
}

}  // namespace
}  // namespace weft::agents
