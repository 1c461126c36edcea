#include "server/traffic/overlay.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/run_with_bypass.hpp"

/// Tests what is closed for single goals, and for how long.
namespace weft::server::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

/// Arranges the run with its bypass, and another run over its floor from place 8 on, a quarter of a metre behind it.
struct OverlayTest : RunWithBypass {
  OverlayTest() {
    Handed over = again.next(10);
    over.batch.edges.push_back(stitch(run.place(8), again.place(0), 0.25, 0.1));
    site.hand_in(r1, over);
    route.goal = goal_id(1);
    route.robot = r1.id;
    for (std::uint32_t i = 0; i < 40; ++i) {
      route.places.push_back(run.place(i));
      if (i > 0) route.relations.emplace_back(Metric2{{0.5, 0.0, 0.0}, Eigen::Matrix3d::Identity() * 1e-6});
    }
  }
  const Closure& close(std::uint32_t at, ClosedFor whom = ClosedFor::goal) {
    return *overlay.close(site.service().snapshot(), route, at, "r1", whom, site.now);
  }
  const ClosedHops& closed() { return *overlay.closed(goal_id(1)); }

  TaughtRun again{r1, 12};
  Route route;
  Overlay overlay;
};

TEST_F(OverlayTest, ClosesAStretchInFrontOfTheRobotInBothDirections) {
  const Closure& closure = close(10);
  EXPECT_EQ(closure.from, run.place(11)) << "place 11 lies where the body is";
  EXPECT_EQ(closure.to, run.place(13));
  EXPECT_THAT(closed(), Contains(Span{run.place(11), run.place(12)}));
  EXPECT_THAT(closed(), Contains(Span{run.place(13), run.place(12)}));
  EXPECT_THAT(closed(), Not(Contains(Span{run.place(10), run.place(11)})));
  EXPECT_THAT(closed(), Not(Contains(Span{run.place(13), run.place(14)})));
}

TEST_F(OverlayTest, ClosesTheSameFloorOfOtherRunsAndNotTheBypass) {
  close(10);
  EXPECT_THAT(closed(), Contains(Span{again.place(3), again.place(4)}));
  EXPECT_THAT(closed(), Contains(Span{again.place(4), again.place(3)}));
  EXPECT_THAT(closed(), Not(Contains(Span{bypass.place(1), bypass.place(2)})));
}

TEST_F(OverlayTest, ClosesTheLastHopWhereTheRouteEndsBefore) {
  EXPECT_EQ(close(39).to, run.place(39));
  EXPECT_THAT(closed(), Contains(Span{run.place(38), run.place(39)}));
  route.places.resize(1);
  EXPECT_EQ(overlay.close(site.service().snapshot(), route, 0, "r1", ClosedFor::goal, site.now), nullptr);
}

TEST_F(OverlayTest, IsForOneGoalAndForTenMinutes) {
  close(10);
  EXPECT_EQ(overlay.closed(goal_id(2)), nullptr);
  EXPECT_EQ(overlay.next(), site.now.steady + 10min);
  EXPECT_THAT(overlay.take_over(site.now.steady + 10min - 1ms), IsEmpty());
  const auto over = overlay.take_over(site.now.steady + 10min);
  ASSERT_THAT(over, SizeIs(1));
  EXPECT_EQ(over.front().goal, goal_id(1));
  EXPECT_EQ(overlay.closed(goal_id(1)), nullptr);
  EXPECT_FALSE(overlay.next());
}

TEST_F(OverlayTest, KeepsWhatIsStillClosedWhenSomeIsOver) {
  close(10);
  site.pass(1min);
  close(20);
  EXPECT_THAT(overlay.take_over(site.now.steady + 9min), SizeIs(1));
  EXPECT_THAT(closed(), Not(Contains(Span{run.place(11), run.place(12)})));
  EXPECT_THAT(closed(), Contains(Span{run.place(21), run.place(22)}));
}

TEST_F(OverlayTest, IsForWhatTheServerAsksOfThatRobotToo) {
  close(10);
  ASSERT_NE(overlay.closed(r1.id), nullptr);
  EXPECT_EQ(*overlay.closed(r1.id), closed());
  EXPECT_EQ(overlay.closed(robot_id(2)), nullptr);
  overlay.forget(goal_id(1));
  EXPECT_EQ(overlay.closed(goal_id(1)), nullptr);
  EXPECT_NE(overlay.closed(r1.id), nullptr) << "it stands there all the same";
  overlay.take_over(site.now.steady + 10min);
  EXPECT_TRUE(overlay.empty());
}

TEST_F(OverlayTest, WhatWasFoundOnAGoalOfTheServersOwnIsForNoGoal) {
  EXPECT_THAT(text_of(close(10, ClosedFor::own_goals)), HasSubstr("closed for what it is asked for by the server"));
  EXPECT_EQ(overlay.closed(goal_id(1)), nullptr);
  ASSERT_NE(overlay.closed(r1.id), nullptr);
  EXPECT_THAT(*overlay.closed(r1.id), Contains(Span{run.place(11), run.place(12)}));
  EXPECT_THAT(overlay.take_driven(route, 13, 14), IsEmpty()) << "no goal waits for it";
  EXPECT_TRUE(overlay.empty());
}

TEST_F(OverlayTest, IsOpenOnceARobotHasComeOutAtTheOtherEnd) {
  close(10);
  EXPECT_THAT(overlay.take_driven(route, 5, 12), IsEmpty()) << "it may stand before the same thing";
  EXPECT_THAT(overlay.take_driven(route, 12, 13), IsEmpty());
  EXPECT_THAT(overlay.take_driven(route, 13, 14), SizeIs(1));
  EXPECT_TRUE(overlay.empty());
}

TEST_F(OverlayTest, SaysWhatIsClosedByWhomAndUntilWhen) {
  const std::string text = text_of(close(10));
  EXPECT_THAT(text, HasSubstr("r1 found the way blocked between " + to_string(run.place(11)) + " and " +
                              to_string(run.place(13)) + " at 1970-01-01T01:23:20.000Z"));
  EXPECT_THAT(text, HasSubstr("closed for this goal until 1970-01-01T01:33:20.000Z"));
}

}  // namespace
}  // namespace weft::server::test
