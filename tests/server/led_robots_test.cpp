#include "server/traffic/plan/led_robots.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace weft::server::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Arranges a robot that is led over three places.
struct LedRobotsTest : testing::Test {
  LedRobotsTest() { robots.lead(one, {place(1), place(2), place(3)}); }
  static PlaceId place(std::uint32_t index) { return {ExperienceId{1}, index}; }

  const RobotId one{1, 1};
  const RobotId other{2, 2};
  LedRobots robots;
};

TEST_F(LedRobotsTest, ARobotIsLedOnByTheNextPlansUntilItIsThere) {
  EXPECT_THAT(robots.led_on(one, place(0), false), ElementsAre(place(1), place(2), place(3)));
  EXPECT_THAT(robots.led_on(one, place(2), true), ElementsAre(place(3)));
  EXPECT_THAT(robots.led_on(one, place(3), true), IsEmpty());
  EXPECT_THAT(robots.led_on(one, place(3), false), IsEmpty());
  EXPECT_THAT(robots.led_on(other, place(0), false), IsEmpty());
}

TEST_F(LedRobotsTest, WhoStandsForManyPlansIsLedNoFarther) {
  for (std::uint32_t plan = 1; plan < LedRobots::kPlansStood; ++plan) {
    ASSERT_EQ(robots.led_on(one, place(0), false).size(), 3U) << plan;
  }
  EXPECT_THAT(robots.led_on(one, place(0), false), IsEmpty());
}

TEST_F(LedRobotsTest, WhoDrivesIsLedOnForAsLongAsItTakes) {
  for (std::uint32_t plan = 0; plan < 3 * LedRobots::kPlansStood; ++plan) {
    ASSERT_THAT(robots.led_on(one, place(1), true), ElementsAre(place(2), place(3)));
  }
}

TEST_F(LedRobotsTest, TheLatestThatWasLedIsKnownAlsoWhenItsWayHasEnded) {
  EXPECT_EQ(robots.led_at(other), 0U);
  robots.lead(other, {place(7)});
  EXPECT_GT(robots.led_at(other), robots.led_at(one));
  robots.end(other);
  EXPECT_THAT(robots.led_on(other, place(6), false), IsEmpty());
  EXPECT_GT(robots.led_at(other), robots.led_at(one));
}

TEST_F(LedRobotsTest, RobotsThatAreNotThereAnyMoreAreForgotten) {
  robots.lead(other, {place(7)});
  robots.forget_unless([this](const RobotId& robot) { return robot == other; });
  EXPECT_EQ(robots.led_at(one), 0U);
  EXPECT_THAT(robots.led_on(one, place(0), false), IsEmpty());
  EXPECT_THAT(robots.led_on(other, place(0), false), ElementsAre(place(7)));
}

}  // namespace
}  // namespace weft::server::test
