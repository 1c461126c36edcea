#include <gmock/gmock.h>

#include <algorithm>

#include "tests/support/board_view.hpp"

namespace weft::agents {
namespace {

using testing::HasSubstr;

CameraModel camera() {
  CameraModel camera;
  camera.width = 640;
  camera.height = 400;
  camera.fx = camera.fy = 400.0;
  camera.cx = 322.0;
  camera.cy = 196.0;
  camera.distortion = {-0.12, 0.03, 0.0005, -0.0004, 0.0};
  return camera;
}

/// Returns the largest distance, in pixels, between what was found and where the pose puts it.
double worst_px(const Sighting& found, const CameraModel& eye, const Pose3& camera_from_board) {
  double worst = 0.0;
  for (std::size_t i = 0; i < found.pixels.size(); ++i) {
    const Eigen::Vector3d on_board(found.on_board[i].x(), found.on_board[i].y(), 0.0);
    const Eigen::Vector2d there = pixel_from_normalised(eye, (camera_from_board * on_board).hnormalized());
    worst = std::max(worst, (there - found.pixels[i]).norm());
  }
  return worst;
}

TEST(Board, ChessboardCornersAreFoundToTenthsOfAPixel) {
  const ChessBoard board{7, 5, 0.03};
  const test::Print print = test::print_of(board);
  const Pose3 pose = test::held(print, camera(), {300.0, 210.0}, 0.5, 0.3, -0.2, 0.05);
  Random random(1);
  const auto found = find_board(test::view_of(print, camera(), pose, random), board);
  ASSERT_TRUE(found);
  ASSERT_EQ(found->pixels.size(), 35U);
  Sighting turned = *found;  // a board of an odd number of corners looks the same from the other side
  std::ranges::reverse(turned.pixels);
  EXPECT_LT(std::min(worst_px(*found, camera(), pose), worst_px(turned, camera(), pose)), 0.4);
}

TEST(Board, TagsAreFoundInEitherOrderAndWithEitherBorder) {
  const TagBoard board{4, 3, 0.06, 0.018};
  for (const bool as_kalibr : {false, true}) {
    const test::Print print = test::print_of(board, as_kalibr);
    const Pose3 pose = test::held(print, camera(), {320.0, 200.0}, 0.45, -0.3, 0.25, 0.1);
    Random random(1);
    const auto found = find_board(test::view_of(print, camera(), pose, random), board);
    ASSERT_TRUE(found) << as_kalibr;
    EXPECT_GE(found->pixels.size(), 40U) << as_kalibr;
    if (!as_kalibr) {
      EXPECT_LT(worst_px(*found, camera(), pose), 0.9);
    }
  }
}

TEST(Board, PartOfATagBoardIsEnough) {
  const TagBoard board{4, 3, 0.06, 0.018};
  const test::Print print = test::print_of(board, false);
  const Pose3 pose = test::held(print, camera(), {30.0, 200.0}, 0.35, 0.0, 0.0, 0.0);
  Random random(1);
  const auto found = find_board(test::view_of(print, camera(), pose, random), board);
  ASSERT_TRUE(found);
  EXPECT_LT(found->pixels.size(), 48U);
  EXPECT_LT(worst_px(*found, camera(), pose), 0.9);
}

TEST(Board, WhatShowsNoneIsNone) {
  const ChessBoard board{7, 5, 0.03};
  const test::Print print = test::print_of(board);
  Random random(1);
  const Image half = test::view_of(print, camera(), test::held(print, camera(), {0.0, 200.0}, 0.4, 0, 0, 0), random);
  EXPECT_FALSE(find_board(half, board));
  EXPECT_FALSE(find_board(half, TagBoard{4, 3, 0.06, 0.018}));
  EXPECT_FALSE(find_board(Image{8, 8, std::make_shared<Bytes>(64)}, board));
  EXPECT_FALSE(find_board(Image{8, 8, std::make_shared<Bytes>(64)}, TagBoard{}));
}

TEST(Board, BoundsAreNamed) {
  EXPECT_TRUE(check(ChessBoard{}));
  EXPECT_TRUE(check(TagBoard{}));
  EXPECT_THAT(check(ChessBoard{2, 6, 0.02}).error().message, HasSubstr("3..50"));
  EXPECT_THAT(check(ChessBoard{6, 6, 0.02}).error().message, HasSubstr("as many columns as rows"));
  EXPECT_THAT(check(ChessBoard{9, 6, 25.0}).error().message, HasSubstr("0.001..2 m"));
  EXPECT_THAT(check(TagBoard{30, 30, 0.1, 0.03}).error().message, HasSubstr("4..587"));
  EXPECT_THAT(check(TagBoard{6, 6, 0.0, 0.03}).error().message, HasSubstr("tag"));
}

}  // namespace
}  // namespace weft::agents
