#include "server/traffic/watches.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

struct WatchesTest : testing::Test {
  RobotId r1 = robot_id(1);
  RobotId r2 = robot_id(2);
  RobotId r3 = robot_id(3);
  Touched here{.place = {ExperienceId{7}, 3}, .reach_m = 0.5};
  Watches watches;
};

TEST_F(WatchesTest, HolderIsAskedAboutThoseThatWaitForIt) {
  watches.watch(r1, here, {r2, r3});
  ASSERT_THAT(watches.on(r2), SizeIs(1));
  EXPECT_EQ(watches.on(r2)[0].waiter, r1);
  EXPECT_EQ(watches.on(r2)[0].needs.place, here.place);
  EXPECT_THAT(watches.on(r3), SizeIs(1));
  EXPECT_THAT(watches.on(r1), IsEmpty());
  EXPECT_THAT(watches.take_woken(), IsEmpty());
}

TEST_F(WatchesTest, WhoIsWokenIsNamedOnceAndWaitsForNothing) {
  watches.watch(r1, here, {r2, r3});
  watches.wake(r1);
  watches.wake(r1);
  EXPECT_THAT(watches.on(r2), IsEmpty());
  EXPECT_THAT(watches.on(r3), IsEmpty());
  EXPECT_THAT(watches.take_woken(), ElementsAre(r1));
  EXPECT_THAT(watches.take_woken(), IsEmpty());
}

TEST_F(WatchesTest, WhoDoesNotWaitIsNotWoken) {
  watches.wake(r1);
  watches.wake_all();
  EXPECT_FALSE(watches.has_woken());
}

TEST_F(WatchesTest, NewWatchTakesTheOldOnesPlace) {
  watches.watch(r1, here, {r2});
  watches.watch(r1, here, {r3});
  EXPECT_THAT(watches.on(r2), IsEmpty());
  watches.watch_everybody(r1);
  EXPECT_THAT(watches.on(r3), IsEmpty());
  watches.watch_map(r1);
  watches.wake_those_for_everybody();
  EXPECT_FALSE(watches.has_woken());
  watches.wake_all();
  EXPECT_THAT(watches.take_woken(), ElementsAre(r1));
}

TEST_F(WatchesTest, WhoIsForgottenIsNotWoken) {
  watches.watch_everybody(r1);
  watches.watch(r2, here, {r3});
  watches.wake(r2);
  watches.forget(r1);
  watches.forget(r2);
  watches.wake_those_for_everybody();
  EXPECT_FALSE(watches.has_woken());
}

}  // namespace
}  // namespace weft::server::test
