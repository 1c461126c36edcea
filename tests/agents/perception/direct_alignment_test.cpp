#include "agents/perception/direct_alignment.hpp"

#include <gtest/gtest.h>

#include "tests/support/flat_floor.hpp"

namespace weft::agents {
namespace {

constexpr Pose2 kStand{0.8, 1.5, 0.2};

AttitudePrior vibrating() {
  Vector6d sigma;
  sigma << 0.001, 0.001, 0.001, 0.001, 0.001, 0.001;
  AttitudePrior prior;
  prior.information = sigma.cwiseAbs2().cwiseInverse().asDiagonal();
  return prior;
}

class DirectAlignment : public testing::Test {
 protected:
  /// Aligns two views of one floor, the second `moved` from the first.
  DirectFit aligned(const test::FlatFloor& floor, const Pose2& moved, const Attitude& attitude, const Pose2& start,
                    const test::Shot& shot) const {
    test::Shot second = shot;
    second.seed = shot.seed + 1;
    const Image a = eye_.render(floor, kStand, {}, shot);
    const Image b = eye_.render(floor, kStand * moved, attitude, second);
    return align_directly(camera_, a, b, vibrating(), {start, {}, {}}, {});
  }
  static double off_mm(const DirectFit& found, const Pose2& moved) {
    return 1e3 * (moved.inverse() * found.fit.state.a_from_b).translation().norm();
  }
  CameraModel camera_ = test::paper_camera();
  test::FloorCamera eye_{camera_};
};

TEST_F(DirectAlignment, FindsAMotionFromAStartBesideIt) {
  const test::FlatFloor floor = test::FlatFloor::procedural(21, 4.0, 3.0);
  const Pose2 moved{0.10, 0.004, 0.03};
  const DirectFit found = aligned(floor, moved, {0.0005, -0.0004, 0.0}, {0.106, 0.0, 0.02}, {});
  EXPECT_TRUE(found.fit.converged);
  EXPECT_GT(found.correlation, 0.8);
  EXPECT_LT(off_mm(found, moved), 0.5);
  EXPECT_NEAR(found.fit.state.a_from_b.heading, moved.heading, 0.0005);
  EXPECT_NEAR(found.fit.state.attitude_b.pitch_rad - found.fit.state.attitude_a.pitch_rad, 0.0005, 0.0003);
}

TEST_F(DirectAlignment, SeesAPaleFloorThroughBlur) {
  const test::FlatFloor floor = test::FlatFloor::procedural(21, 4.0, 3.0, 5.0);
  test::Shot shot;
  shot.blur = {0.015, 0.0, 0.0};
  const Pose2 moved{0.10, 0.0, 0.0};
  const DirectFit found = aligned(floor, moved, {}, {0.104, 0.0, 0.0}, shot);
  EXPECT_TRUE(found.fit.converged);
  EXPECT_LT(off_mm(found, moved), 1.0);
}

TEST_F(DirectAlignment, AnotherPlaceDoesNotCorrelate) {
  const test::FlatFloor floor = test::FlatFloor::procedural(21, 4.0, 3.0);
  const Image a = eye_.render(floor, kStand, {}, {});
  const Image b = eye_.render(floor, {2.4, 1.2, 2.0}, {}, {});
  const DirectFit found = align_directly(camera_, a, b, vibrating(), {{0.02, 0.0, 0.0}, {}, {}}, {});
  EXPECT_LT(found.correlation, 0.5);
}

TEST_F(DirectAlignment, ABlankFloorGivesNoPoints) {
  const test::FlatFloor blank = test::FlatFloor::blank(4.0, 3.0);
  test::Shot quiet;
  quiet.noise = 0.0;
  const DirectFit found = aligned(blank, {0.1, 0.0, 0.0}, {}, {0.1, 0.0, 0.0}, quiet);
  EXPECT_EQ(found.points, 0U);
  EXPECT_FALSE(found.fit.converged);
}

TEST(DirectAlignmentAbove, FindsAMotionUnderACeiling) {
  constexpr double kCeilingM = 2.0;
  const test::FlatFloor ceiling = test::FlatFloor::procedural(24, 7.0, 6.0);
  const CameraModel camera = test::upward_camera(0.035);
  const test::FloorCamera eye(camera, kCeilingM);
  const Pose2 stand{3.0, 3.0, 0.2};
  const Pose2 moved{0.10, 0.004, 0.03};
  const DirectFit found =
      align_directly(camera, eye.render(ceiling, stand, {}, {}), eye.render(ceiling, stand * moved, {}, {}),
                     vibrating(), {{0.08, 0.0, 0.02}, {}, {}}, {.above_floor_m = kCeilingM});
  EXPECT_TRUE(found.fit.converged);
  EXPECT_LT((moved.inverse() * found.fit.state.a_from_b).translation().norm(), 0.002);
}

}  // namespace
}  // namespace weft::agents
