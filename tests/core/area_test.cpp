#include "core/network/area.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace weft {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

using Corners = std::vector<Eigen::Vector2d>;

/// Returns corners on a circle.
Corners round(std::size_t count) {
  Corners corners;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = 6.28 * static_cast<double>(i) / static_cast<double>(count);
    corners.emplace_back(5.0 * std::cos(angle), 5.0 * std::sin(angle));
  }
  return corners;
}

TEST(Areas, EncloseSomethingEitherWayRound) {
  EXPECT_THAT(problem_of({{0, 0}, {4, 0}, {4, 3}}), IsEmpty());
  EXPECT_THAT(problem_of({{4, 3}, {4, 0}, {0, 0}}), IsEmpty());
  EXPECT_THAT(problem_of({{0, 0}, {1, 1}, {2, 2}}), HasSubstr("encloses nothing"));
}

TEST(Areas, HaveFromThreeCornersToTheMost) {
  EXPECT_THAT(problem_of({{0, 0}, {4, 0}}), HasSubstr("has 2 corners"));
  EXPECT_THAT(problem_of(round(kMostCorners)), IsEmpty());
  EXPECT_THAT(problem_of(round(kMostCorners + 1)), HasSubstr("has 101 corners"));
}

TEST(Areas, LieWithinThePlansReach) {
  for (const double bad :
       {1.1e6, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_THAT(problem_of({{0, 0}, {4, 0}, {4, bad}}), HasSubstr("has a corner farther than"));
  }
}

}  // namespace
}  // namespace weft
