#include "core/network/difference.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft {
namespace {

Metric3 in_space(const Vector6d& xi, double sigma) {
  return {se3_exp(xi), sigma * sigma * Matrix6d::Identity()};
}
Vector6d along_axis(Eigen::Index axis, double value) {
  Vector6d xi = Vector6d::Zero();
  xi[axis] = value;
  return xi;
}

TEST(DifferenceOfRelations, OfTwoInSpaceIsInSpace) {
  const Metric3 here = in_space(Vector6d::Zero(), 0.01);
  for (Eigen::Index axis = 0; axis < 6; ++axis) {
    const Metric3 there = in_space(along_axis(axis, 0.3), 0.01);
    EXPECT_NEAR(difference(here, there).metres, axis < 3 ? 0.3 : 0.0, 1e-9) << axis;
    EXPECT_NEAR(difference(here, there).radians, axis < 3 ? 0.0 : 0.3, 1e-9) << axis;
    EXPECT_NEAR(sigmas_apart(here, there, 0.0, 0.0), 0.3 / (0.01 * std::sqrt(2.0)), 1e-6) << axis;
    EXPECT_NEAR(sigmas_apart(here, there, 0.3, 0.3), 1.0, 0.01) << axis;
  }
}

TEST(DifferenceOfRelations, WithOneOfThePlaneIsInThePlane) {
  const Metric3 above = in_space(along_axis(2, 0.5), 0.01);
  EXPECT_NEAR(difference(Metric2{}, above).metres, 0.0, 1e-9);
  EXPECT_LT(sigmas_apart(Metric2{}, above, 0.01, 0.01), 0.01);
  EXPECT_NEAR(difference(Metric2{{0.3, 0.4, 0.1}}, Metric2{}).metres, 0.5, 1e-9);
  EXPECT_NEAR(difference(AlongPath{0.3}, AlongPath{0.1}).metres, 0.2, 1e-9);
}

TEST(DifferenceOfRelations, ASpreadIsThatOfTheWorstAxis) {
  Matrix6d covariance = 1e-4 * Matrix6d::Identity();
  covariance(2, 2) = 0.04;
  covariance(4, 4) = 0.09;
  const Difference spread = spread_of(Metric3{Pose3{}, covariance});
  EXPECT_NEAR(spread.metres, 0.2, 1e-12);
  EXPECT_NEAR(spread.radians, 0.3, 1e-12);
  Metric2 flat;
  flat.covariance.diagonal() << 0.01, 0.04, 0.25;
  EXPECT_NEAR(spread_of(flat).metres, 0.2, 1e-12);
  EXPECT_NEAR(spread_of(flat).radians, 0.5, 1e-12);
}

}  // namespace
}  // namespace weft
