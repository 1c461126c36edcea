#include "agents/navigation/route_limit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::agents {
namespace {

constexpr double kRadius_m = 0.4;
constexpr double kBrake_m_s2 = 0.5;

/// Arranges a straight route of places half a metre apart, of which those from 0 to 8 are laid out.
struct Straight {
  explicit Straight(std::uint32_t stands_on) {
    for (std::uint32_t index = 0; index < 30; ++index) route.places.push_back({ExperienceId{1}, index});
    for (std::uint32_t index = 0; index <= 8; ++index) {
      around.poses.push_back({index, {0.5 * (static_cast<double>(index) - stands_on), 0.0, 0.0}});
    }
    around.nearest = stands_on;
    at = stands_on;
  }
  std::optional<double> limit() const { return route_limit(route, around, at, kRadius_m, kBrake_m_s2); }

  Route route;
  RouteAround around;
  std::uint32_t at = 0;
};

TEST(RouteLimit, WithoutLimitsThereIsNone) {
  EXPECT_EQ(Straight(2).limit(), std::nullopt);
}

TEST(RouteLimit, HoldsFromItsFirstPlaceToItsLast) {
  for (const std::uint32_t at : {3U, 4U, 5U}) {
    Straight straight(at);
    straight.route.limits = {{3, 5, 0.3}};
    EXPECT_DOUBLE_EQ(straight.limit().value(), 0.3) << at;
  }
  Straight behind(6);
  behind.route.limits = {{3, 5, 0.3}};
  EXPECT_EQ(behind.limit(), std::nullopt);
}

TEST(RouteLimit, IsBrakedForBeforeTheFootprintIsThere) {
  double before = 100.0;
  for (std::uint32_t at = 0; at <= 3; ++at) {
    Straight straight(at);
    straight.route.limits = {{3, 5, 0.3}};
    const double limit = straight.limit().value();
    EXPECT_LT(limit, before) << "slower the nearer";
    const double left_m = std::max(0.0, 0.5 * (3.0 - at) - kRadius_m);
    EXPECT_LE(limit * limit - 0.3 * 0.3, 2.0 * kBrake_m_s2 * left_m + 1e-9) << "it can brake until there";
    before = limit;
  }
}

TEST(RouteLimit, TheLowestOfSeveralCounts) {
  Straight straight(4);
  straight.route.limits = {{2, 8, 0.5}, {3, 5, 0.2}, {20, 22, 0.1}};
  EXPECT_DOUBLE_EQ(straight.limit().value(), 0.2);
}

TEST(RouteLimit, OfOneThatLiesBeyondWhatIsLaidOutItTakesTheNearestThatItCanBe) {
  Straight straight(0);
  straight.route.limits = {{20, 22, 0.1}};
  EXPECT_NEAR(straight.limit().value(), std::sqrt(0.01 + 2.0 * 0.8 * kBrake_m_s2 * (4.0 - kRadius_m)), 1e-9);
}

}  // namespace
}  // namespace weft::agents
