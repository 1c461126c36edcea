#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/server/traffic_site.hpp"

/// Tests how an operator frees what robots hold that have left the floor or have to be moved by hand.
namespace weft::server::test {
namespace {

using testing::HasSubstr;
using testing::SizeIs;

msg::OperatorReply clear(Site& site, const std::string& robot, bool is_sure = false) {
  msg::OperatorRequest request = site.request(msg::OperatorRequest::Kind::clear);
  request.robot = robot;
  request.is_sure = is_sure;
  return site.ask(request);
}

TEST_F(TrafficTest, OperatorClearsARobotThatIsGone) {
  site.stand_stopped(r2, run.place(30));
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "end", "r1");
  site.pass(20s);
  EXPECT_EQ(clear(site, "r2").outcome, msg::Outcome::done);
  drives(r1);
  site.pass(1s);
  EXPECT_EQ(site.order_to(r1)->released, 59U);
  EXPECT_THAT(site.events_of("traffic.cleared"), SizeIs(1));
}

TEST_F(TrafficTest, ARobotThatWasClearedAndNeverMovedIsReleasedAgain) {
  site.say(site.state(r1, run.place(0)));
  site.pass(20s);
  EXPECT_EQ(clear(site, "r1").outcome, msg::Outcome::done);
  r1.incarnation = 2;
  site.arrive(r1, run.place(0));
  site.send_goal(1, "end", "r1");
  site.pass(1s);
  EXPECT_EQ(site.order_to(r1).value().released, 59U);
}

TEST_F(TrafficTest, ClearingARobotThatIsHeardIsRefused) {
  site.stand_stopped(r2, run.place(30));
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "end", "r1");
  const std::uint32_t before = site.order_to(r1)->released;
  const msg::OperatorReply reply = clear(site, "r2");
  EXPECT_EQ(reply.outcome, msg::Outcome::refused);
  EXPECT_THAT(reply.message, HasSubstr("weft robot clear r2 --yes"));
  site.pass(1s);
  EXPECT_EQ(site.order_to(r1)->released, before);
}

TEST_F(TrafficTest, ClearingARobotThatIsHeardForSureFreesItsRouteAndNotItsPlace) {
  site.say(site.state(r1, run.place(0)));
  site.say(site.state(r2, run.place(25)));
  site.send_goal(2, "end", "r2");
  site.send_goal(1, "end", "r1");
  const Route first = site.order_to(r2).value();
  site.progress(r2, first, msg::RoutePhase::driving, 5);
  msg::RobotState on_its_way = site.state(r2, run.place(32));
  on_its_way.route = first.id;
  on_its_way.mode = msg::RobotMode::driving;
  site.say(on_its_way);
  EXPECT_EQ(clear(site, "r2", true).outcome, msg::Outcome::done);
  EXPECT_EQ(site.goal(2).state, GoalState::failed);
  EXPECT_EQ(site.disk->occupancies.at(r2.id).held.places, std::vector<PlaceId>{run.place(32)});
  site.pass(1s);
  EXPECT_LE(site.order_to(r1)->released, 29U) << "r2 stands at 32";
  expect_apart();
  // It rolled on before it had the order to end its route.
  on_its_way = site.state(r2, run.place(34));
  on_its_way.route = first.id;
  site.say(on_its_way);
  EXPECT_EQ(site.disk->occupancies.at(r2.id).held.places, std::vector<PlaceId>{run.place(34)});
  // Silent, and cleared again: now nothing is held for it.
  site.pass(20s);
  EXPECT_EQ(clear(site, "r2").outcome, msg::Outcome::done);
  drives(r1);
  site.pass(1s);
  EXPECT_EQ(site.order_to(r1)->released, 59U);
}

TEST_F(TrafficTest, ClearingARobotWithAGoalFailsTheGoal) {
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "end", "r1");
  site.pass(20s);
  EXPECT_EQ(clear(site, "r1").outcome, msg::Outcome::done);
  EXPECT_EQ(site.goal(1).state, GoalState::failed);
}

}  // namespace
}  // namespace weft::server::test
