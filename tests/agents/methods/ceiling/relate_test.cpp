#include <gtest/gtest.h>

#include <cmath>

#include "agents/methods/ceiling/ceiling.hpp"
#include "tests/agents/methods/ceiling/rendered_ceiling.hpp"

namespace weft::agents {
namespace {

Ceiling relating(double height_m) {
  CeilingConfig config;
  config.height_m = height_m;
  return *Ceiling::make(config, test::up_camera(0.03, -0.02));
}

TEST(CeilingRelate, FindsAnyHeadingWithoutAGuess) {
  const Ceiling method = relating(6.4);
  test::RenderedCeiling hall = test::hall_ceiling(6.4);
  const auto a = method.extract({}, hall.view(method.camera(), {}, {}, 1));
  ASSERT_TRUE(a);
  for (const double heading : {0.0, 1.0, 2.4, -1.6}) {
    const Pose2 a_from_b{0.3, -0.2, heading};
    const auto b = method.extract({}, hall.view(method.camera(), a_from_b, {0.0008, -0.0008, 0.0}, 2));
    ASSERT_TRUE(b);
    const auto related = method.relate(*a, *b, std::nullopt);
    ASSERT_TRUE(related) << related.error().reason << " at " << heading;
    const Eigen::Vector3d off = se2_log(a_from_b.inverse() * planar(related->a_from_b));
    EXPECT_LT(off.head<2>().norm(), 0.05);
    EXPECT_LT(std::abs(off.z()), 0.01);
    EXPECT_LT(off.dot(planar_covariance(related->a_from_b).inverse() * off), 16.0);
  }
}

TEST(CeilingRelate, AnotherCeilingIsRefused) {
  const Ceiling method = relating(6.4);
  test::RenderedCeiling here = test::hall_ceiling(6.4, 1);
  test::RenderedCeiling there = test::hall_ceiling(6.4, 100);
  const auto a = method.extract({}, here.view(method.camera(), {}, {}, 1));
  const auto b = method.extract({}, there.view(method.camera(), {}, {}, 2));
  ASSERT_TRUE(a && b);
  EXPECT_FALSE(method.relate(*a, *b, std::nullopt));
  CeilingContent higher = *b;
  higher.ceiling_m = 9.0;
  EXPECT_EQ(method.relate(*a, higher, std::nullopt).error().reason, "other_ceiling");
}

TEST(CeilingRelate, AGridOfLampsIsNeverConfidentlyWrong) {
  CeilingConfig config;
  config.height_m = 4.0;
  config.fewest_features = 12;
  const Ceiling method = *Ceiling::make(config, test::up_camera());
  test::RenderedCeiling grid;
  for (int column = -6; column <= 6; ++column)
    for (int row = -6; row <= 6; ++row)
      grid.panels.push_back({4.0, test::box(1.5 * column, 1.8 * row, 0.6, 0.3), true});
  const auto a = method.extract({}, grid.view(method.camera(), {}, {}, 1));
  ASSERT_TRUE(a);
  for (const Pose2& a_from_b :
       {Pose2{1.5, 0.0, 0.0}, Pose2{0.4, 0.2, 3.0}, Pose2{0.0, 1.8, 0.1}, Pose2{3.0, 0.1, 0.0}}) {
    const auto b = method.extract({}, grid.view(method.camera(), a_from_b, {}, 2));
    ASSERT_TRUE(b);
    EXPECT_FALSE(method.relate(*a, *b, std::nullopt));
  }
}

/// Returns a grid of lamps that light the ceiling about them: what is beside a lamp tells of it too.
test::RenderedCeiling lit_grid() {
  constexpr double apart_x_m = 1.5;
  constexpr double apart_y_m = 1.8;
  test::RenderedCeiling grid;
  test::Panel lit{4.0, test::box(-8.0, -8.0, 16.0, 16.0)};
  lit.px_m = 0.02;
  lit.columns = 801;
  for (int row = 0; row < lit.columns; ++row)
    for (int column = 0; column < lit.columns; ++column) {
      const Eigen::Vector2d at = lit.box.min() + lit.px_m * Eigen::Vector2d(column + 0.5, row + 0.5);
      const Eigen::Vector2d off(std::remainder(at.x() - 0.3, apart_x_m), std::remainder(at.y() - 0.15, apart_y_m));
      lit.greys.push_back(static_cast<std::uint8_t>(60.0 + 120.0 * std::exp(-off.norm() / 0.5)));
    }
  grid.panels.push_back(lit);
  for (int column = -5; column <= 5; ++column)
    for (int row = -4; row <= 4; ++row)
      grid.panels.push_back({3.99, test::box(apart_x_m * column, apart_y_m * row, 0.6, 0.3), true});
  return grid;
}

TEST(CeilingRelate, BelowLampsThatAreAllAlikeTheReasonIsThatTheyAre) {
  CeilingConfig config;
  config.height_m = 4.0;
  const Ceiling method = *Ceiling::make(config, test::up_camera());
  test::RenderedCeiling grid = lit_grid();
  const auto a = method.extract({}, grid.view(method.camera(), {}, {}, 1));
  ASSERT_TRUE(a);
  for (const Pose2& a_from_b : {Pose2{1.5, 0.0, 0.0}, Pose2{0.4, 0.2, 3.0}}) {
    const auto b = method.extract({}, grid.view(method.camera(), a_from_b, {}, 2));
    ASSERT_TRUE(b);
    const auto related = method.relate(*a, *b, std::nullopt);
    ASSERT_FALSE(related);
    EXPECT_EQ(related.error().reason, "ambiguous");
  }
}

}  // namespace
}  // namespace weft::agents
