#include "server/traffic/traffic.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/traffic/proximity.hpp"
#include "tests/server/traffic_site.hpp"

namespace weft::server::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

TEST_F(TrafficTest, FreeRouteIsReleasedAsAWhole) {
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "end", "r1");
  EXPECT_EQ(site.order_to(r1)->released, 59U);
  EXPECT_EQ(site.disk->occupancies.at(r1.id).to, 59U);
}

TEST_F(TrafficTest, StandingRobotIsInTheWayUntilItLeaves) {
  site.stand_stopped(r2, run.place(30));
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "end", "r1");
  ASSERT_TRUE(site.order_to(r1));
  EXPECT_GE(site.order_to(r1)->released, 24U);
  EXPECT_LE(site.order_to(r1)->released, 27U);
  expect_apart();
  EXPECT_THAT(site.goal(1).history.back().cause, HasSubstr("r2"));
  site.progress(r1, *site.order_to(r1), msg::RoutePhase::driving, 1);
  const std::uint32_t before = site.order_to(r1)->released;
  site.stand_stopped(r2, run.place(45));
  site.pass(1s);
  EXPECT_GT(site.order_to(r1)->released, before + 10);
  EXPECT_EQ(site.order_to(r1)->version, 1U);
  expect_apart();
}

TEST_F(TrafficTest, WhoWaitsForAnotherOneNowIsToldForWhom) {
  Peer r3{.id = robot_id(3), .name = "r3"};
  site.arrive(r3, std::nullopt);
  site.stand_stopped(r2, run.place(30));
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "end", "r1");
  const std::uint32_t released = site.order_to(r1).value().released;
  EXPECT_EQ(site.order_to(r1)->reason, "waits for r2");
  site.progress(r1, *site.order_to(r1), msg::RoutePhase::waiting, 1);
  site.stand_stopped(r3, run.place(30));
  site.stand_stopped(r2, run.place(45));
  site.pass(2s);
  EXPECT_EQ(site.order_to(r1)->released, released);
  EXPECT_EQ(site.order_to(r1)->reason, "waits for r3");
}

TEST_F(TrafficTest, WhoDrivesYetIsNotSaidToWait) {
  site.stand_stopped(r2, run.place(30));
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "end", "r1");
  ASSERT_THAT(site.events_of("goal.waits"), SizeIs(1));
  site.progress(r1, site.order_to(r1).value(), msg::RoutePhase::driving, 1);
  site.pass(2s);
  EXPECT_THAT(site.events_of("goal.goes_on"), SizeIs(1));
  EXPECT_THAT(site.events_of("goal.waits"), SizeIs(1));
  const Route route = site.order_to(r1).value();
  site.progress(r1, route, msg::RoutePhase::waiting, route.released);
  site.pass(2s);
  EXPECT_THAT(site.events_of("goal.waits"), SizeIs(2));
}

TEST_F(TrafficTest, RoomIsLeftForTheFirstStepOfOneThatStands) {
  site.stand_stopped(r2, run.place(30));
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "end", "r1");
  ASSERT_TRUE(site.order_to(r1));
  // A stitch may lead it to a place behind it first.
  storage::PutOccupancy step_back;
  step_back.robot = r2.id;
  step_back.held.places = {run.place(29)};
  Proximity proximity(3.0);
  EXPECT_FALSE(proximity.overlap(site.service().snapshot(), touched_by(site.disk->occupancies.at(r1.id), 0.4),
                                 touched_by(step_back, 0.4)));
}

TEST_F(TrafficTest, LaterRobotFollowsAsFarAsTheFirstFrees) {
  site.say(site.state(r1, run.place(10)));
  site.say(site.state(r2, run.place(0)));
  site.send_goal(1, "end", "r1");
  const Route first = site.order_to(r1).value();
  site.send_goal(2, "middle", "r2");
  ASSERT_TRUE(site.order_to(r2));
  EXPECT_LE(site.order_to(r2)->released, 7U);
  expect_apart();
  std::uint32_t released = site.order_to(r2)->released;
  for (const std::uint32_t freed : {5U, 10U, 20U, 49U}) {
    site.progress(r1, first, msg::RoutePhase::driving, freed);
    site.pass(1s);
    EXPECT_GE(site.order_to(r2)->released, released);
    released = site.order_to(r2)->released;
    expect_apart();
  }
  EXPECT_EQ(released, 20U);
}

TEST_F(TrafficTest, NobodyIsSentWhereARobotWasPutDownThatHasLostItsRoute) {
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "middle", "r1");
  drives(r1);
  site.pass(4s);
  // It was carried off and told where it is; no way leads back from there to its goal.
  for (int i = 0; i < 3; ++i) {
    site.say(site.state(r1, run.place(50)));
    site.pass(1500ms);
  }
  site.say(site.state(r2, run.place(30)));
  site.send_goal(2, "end", "r2");
  site.pass(2s);
  ASSERT_TRUE(site.order_to(r2));
  EXPECT_LT(site.order_to(r2)->released, 20U) << "r1 stands at the twentieth place of that route";
  EXPECT_GT(site.order_to(r2)->released, 10U);
}

TEST_F(TrafficTest, NobodyIsSentWhereARobotWasPutDownThatHasLostItsRouteAndIsStopped) {
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "middle", "r1");
  drives(r1);
  site.pass(4s);
  // It was carried off and told where it is; no way leads back from there to its goal.
  for (int i = 0; i < 3; ++i) {
    site.stand_stopped(r1, run.place(50));
    site.pass(1500ms);
  }
  site.say(site.state(r2, run.place(30)));
  site.send_goal(2, "end", "r2");
  site.pass(2s);
  ASSERT_TRUE(site.order_to(r2));
  EXPECT_LT(site.order_to(r2)->released, 20U) << "r1 stands at the twentieth place of that route";
  EXPECT_GT(site.order_to(r2)->released, 10U);
}

TEST_F(TrafficTest, TimeFreesNothing) {
  site.stand_stopped(r2, run.place(30));
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "end", "r1");
  const std::uint32_t before = site.order_to(r1)->released;
  site.pass(3600s);
  EXPECT_EQ(site.order_to(r1)->released, before);
}

TEST_F(TrafficTest, RestartGivesNothingAway) {
  site.say(site.state(r2, run.place(30)));
  site.say(site.state(r1, run.place(0)));
  site.restart();
  site.arrive(r1, run.place(0));
  site.send_goal(1, "end", "r1");
  ASSERT_TRUE(site.order_to(r1));
  EXPECT_LE(site.order_to(r1)->released, 27U) << "r2 has not been heard, and holds its place all the same";
}

TEST_F(TrafficTest, RunsOverOneFloorMeetThroughAStitch) {
  TaughtRun other(r2, 11);
  site.hand_in(r2, other.next(10));
  site.say(site.state(r2, other.place(5)));
  site.say(site.state(r1, run.place(0)));
  Handed more = other.next(1);
  more.batch.edges.push_back(stitch(run.place(40), other.place(10), 0.2));
  site.hand_in(r2, more);
  site.send_goal(1, "end", "r1");
  ASSERT_TRUE(site.order_to(r1));
  // other's place 5 lies 2.5 m behind its place 10, which lies 0.2 m ahead of place 40: beside place 35.
  EXPECT_GE(site.order_to(r1)->released, 30U);
  EXPECT_LE(site.order_to(r1)->released, 32U);
  expect_apart();
}

TEST_F(TrafficTest, RunsThatMeetFarFromTheirStitchAreOneFloor) {
  // Both begin at one place and come together again 20 m on.
  TaughtRun other(r2, 11);
  Handed beside = other.next(41);
  beside.batch.edges.push_back(stitch(run.place(0), other.place(0), 0.0, 0.2));
  site.hand_in(r2, beside);
  site.stand_stopped(r2, other.place(40));
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "end", "r1");
  ASSERT_TRUE(site.order_to(r1));
  EXPECT_GE(site.order_to(r1)->released, 30U);
  EXPECT_LE(site.order_to(r1)->released, 37U);
  EXPECT_THAT(site.goal(1).history.back().cause, HasSubstr("r1 waits until r2 has left its way"));
  expect_apart();
}

TEST_F(TrafficTest, NothingIsReleasedBeforeItIsKnownWherePlacesLie) {
  TaughtRun large(r2, 12);
  for (int i = 0; i < 5; ++i) site.hand_in(r2, large.next(1000, 1));
  site.label("far", large.place(4));
  site.pass(2s);
  site.restart();
  site.arrive(r1, large.place(0));
  site.send_goal(1, "far", "r1");
  EXPECT_EQ(site.goal(1).state, GoalState::assigned);
  EXPECT_FALSE(site.order_to(r1));
  EXPECT_THAT(site.goal(1).history.back().cause, HasSubstr("laid out"));
  site.pass(1s);
  ASSERT_TRUE(site.order_to(r1));
  EXPECT_EQ(site.order_to(r1)->released, 4U);
}

TEST_F(TrafficTest, RobotsInPartsThatNothingJoinsAreWarnedOfOnce) {
  TaughtRun other(r2, 11);
  site.hand_in(r2, other.next(10));
  EXPECT_THAT(site.info().unjoined, IsEmpty());
  site.say(site.state(r2, other.place(5)));
  site.say(site.state(r1, run.place(0)));
  site.say(site.state(r1, run.place(7)));
  ASSERT_THAT(site.events_of("traffic.unjoined"), SizeIs(1));
  EXPECT_THAT(site.events_of("traffic.unjoined").front(), HasSubstr("the part with r1 and that with r2"));
  EXPECT_THAT(site.events_of("traffic.unjoined").front(), HasSubstr("unjoined = one_drives"));
  EXPECT_THAT(site.info().unjoined, HasSubstr("teach a way that joins them"));
  Handed more = other.next(1);
  more.batch.edges.push_back(stitch(run.place(40), other.place(10), 0.2));
  site.hand_in(r2, more);
  EXPECT_THAT(site.events_of("traffic.joined"), SizeIs(1));
  EXPECT_THAT(site.info().unjoined, IsEmpty());
}

TEST_F(TrafficTest, OfRobotsThatNothingJoinsOneDrivesAtATimeWhereThatIsSet) {
  site.unjoined = Unjoined::one_drives;
  TaughtRun other(r2, 11);
  site.hand_in(r2, other.next(30));
  site.label("there", other.place(29));
  site.restart();
  site.arrive(r2, other.place(0));
  site.arrive(r1, run.place(0));
  site.send_goal(1, "end", "r1");
  const Route first = site.order_to(r1).value();
  EXPECT_EQ(first.released, 59U);
  site.send_goal(2, "there", "r2");
  EXPECT_FALSE(site.order_to(r2));
  EXPECT_THAT(site.goal(2).history.back().cause, HasSubstr("r2 waits until r1 has arrived"));
  site.progress(r1, first, msg::RoutePhase::arrived, 59);
  site.pass(1s);
  ASSERT_TRUE(site.order_to(r2));
  EXPECT_EQ(site.order_to(r2)->released, 29U);
}

TEST_F(TrafficTest, RobotThatDoesNotKnowWhereItIsHoldsNothing) {
  site.say(site.state(r2, std::nullopt));
  EXPECT_THAT(site.disk->occupancies, IsEmpty());
}

}  // namespace
}  // namespace weft::server::test
