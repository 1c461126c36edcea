#include "tests/simulation/ways_by_hand.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::simulation {
namespace {

TEST(WaysByHand, LeadWhereTheyShallSmoothly) {
  const Pose2 from{1.0, 2.0, 0.5};
  for (const Pose2& to : {Pose2{6.0, 1.0, -2.0}, Pose2{-4.0, 2.0, 0.5}, Pose2{1.0, 2.2, 3.0}, Pose2{2.0, 2.0, 0.4}}) {
    const auto ways = ways_by_hand(from, to);
    ASSERT_GE(ways.size(), 2U);
    for (const auto& way : ways) {
      EXPECT_NEAR(way.front().x, from.x, 1e-9);
      EXPECT_NEAR(way.back().x, to.x, 1e-9);
      EXPECT_NEAR(way.back().y, to.y, 1e-9);
      double heading = from.heading;
      for (std::size_t i = 1; i < way.size(); ++i) {
        const double next = std::atan2(way[i].y - way[i - 1].y, way[i].x - way[i - 1].x);
        EXPECT_LT(std::abs(wrap_angle(next - heading)), 0.32) << i;
        heading = next;
      }
      EXPECT_LT(std::abs(wrap_angle(to.heading - heading)), 0.2);
    }
  }
}

TEST(WaysByHand, TheShortestComesFirst) {
  const auto ways = ways_by_hand({0.0, 0.0, 0.0}, {5.0, 0.0, 0.0});
  EXPECT_EQ(ways.front().size(), 21U);
  EXPECT_GT(ways.back().size(), ways.front().size());
}

}  // namespace
}  // namespace weft::simulation
