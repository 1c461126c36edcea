#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"
#include "tests/server/given_up.hpp"

namespace weft::server::test {
namespace {

using Kind = msg::OperatorRequest::Kind;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct GoalLife : testing::Test {
  GoalLife() {
    site.arrive(r1, std::nullopt);
    site.hand_in(r1, run.next(40));
    site.label("dock", run.place(39));
    site.hush();
  }
  msg::OperatorReply cancel(std::uint8_t number) {
    msg::OperatorRequest cancel = site.request(Kind::goal_cancel);
    cancel.goal = goal_id(number);
    return site.ask(cancel);
  }
  /// Gives r1 goal 1 and lets it accept its route, which is returned.
  Route start() {
    site.say(site.state(r1, run.place(0)));
    site.send_goal(1, "dock", "r1");
    site.pass(1s);
    const Route route = site.order();
    site.progress(r1, route, msg::RoutePhase::accepted);
    return route;
  }
  /// Sends r1 from the end of a second run, which lies at (x, y) of the first one's sixth place and is joined to it
  /// by an edge that cannot be driven.
  void send_from_an_end_at(double x, double y) {
    TaughtRun second(r1, 11);
    Handed handed = second.next(3);
    Edge edge = stitch(run.place(5), second.place(2), x, y);
    edge.drivable = Drivable::none;
    handed.batch.edges.push_back(edge);
    site.hand_in(r1, handed);
    site.say(site.state(r1, second.place(2)));
    site.send_goal(1, "dock", "r1");
    site.pass(1s);
  }
  /// Says as r1 that it follows nothing, and stands there.
  void stand(const PlaceId& place) { site.say(site.state(r1, place)); }
  /// Has r1 give its route up, and say why.
  void give_up(const Route& route, const std::string& reason) { site.say(given_up(r1, route, reason)); }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  TaughtRun run{r1, 10};
};

TEST_F(GoalLife, FromAskedForToSucceeded) {
  site.say(site.state(r1, run.place(2)));
  const msg::OperatorReply reply = site.send_goal(1, "dock");
  EXPECT_EQ(reply.outcome, msg::Outcome::accepted);
  EXPECT_EQ(site.goal(1).state, GoalState::assigned);
  const Route route = site.order();
  EXPECT_EQ(route.places.front(), run.place(2));
  EXPECT_EQ(route.places.back(), run.place(39));
  EXPECT_EQ(route.released, 37U);
  EXPECT_EQ(route.version, 1U);
  site.progress(r1, route, msg::RoutePhase::driving, 3);
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
  site.progress(r1, route, msg::RoutePhase::arrived, 30);
  EXPECT_EQ(site.goal(1).state, GoalState::succeeded);
  EXPECT_TRUE(site.order().ended);
  std::vector<GoalState> life;
  for (const GoalEvent& event : site.goal(1).history) life.push_back(event.state);
  EXPECT_THAT(life, testing::ElementsAre(GoalState::pending, GoalState::assigned, GoalState::executing,
                                         GoalState::succeeded));
  EXPECT_THAT(site.events_of("goal.succeeded"), SizeIs(1));
}

TEST_F(GoalLife, WhereNothingLeadsOnItSetsOffFromAPlaceBesideIt) {
  send_from_an_end_at(0.1, 0.1);
  EXPECT_EQ(site.goal(1).state, GoalState::assigned) << site.goal(1).history.back().cause;
  EXPECT_EQ(site.order().places.front(), run.place(5));
}

TEST_F(GoalLife, FarFromEveryWayItSaysSo) {
  send_from_an_end_at(0.0, 0.6);
  EXPECT_EQ(site.goal(1).state, GoalState::pending);
  EXPECT_THAT(site.goal(1).history.back().cause, HasSubstr("teach a connection"));
}

TEST_F(GoalLife, AcceptedMeansStored) {
  site.disk->faults.full = true;
  EXPECT_EQ(site.send_goal(1, "dock").outcome, msg::Outcome::refused);
  EXPECT_THAT(site.service().goals(), IsEmpty());
  site.disk->faults.full = false;
  EXPECT_EQ(site.send_goal(2, "dock").outcome, msg::Outcome::accepted);
  EXPECT_TRUE(site.disk->goals.contains(goal_id(2)));
}

TEST_F(GoalLife, UnknownLabelAndRobotAreRejectedAtOnce) {
  const msg::OperatorReply nowhere = site.send_goal(1, "moon");
  EXPECT_EQ(nowhere.outcome, msg::Outcome::refused);
  EXPECT_THAT(nowhere.message, HasSubstr("moon"));
  EXPECT_THAT(nowhere.message, HasSubstr("dock"));
  EXPECT_EQ(site.goal(1).state, GoalState::rejected);
  const msg::OperatorReply nobody = site.send_goal(2, "dock", "r9");
  EXPECT_EQ(nobody.outcome, msg::Outcome::refused);
  EXPECT_THAT(nobody.message, HasSubstr("r9"));
  EXPECT_EQ(site.goal(2).state, GoalState::rejected);
}

TEST_F(GoalLife, RepeatedRequestIsDoneOnce) {
  msg::OperatorRequest send = site.request(Kind::goal_send);
  send.goal = goal_id(1);
  send.label = "dock";
  send.no_return = true;
  const msg::OperatorReply first = site.ask(send);
  const msg::OperatorReply second = site.ask(send);
  EXPECT_EQ(first.message, second.message);
  EXPECT_EQ(site.send_goal(1, "dock").outcome, msg::Outcome::accepted) << "another number, the same goal";
  EXPECT_EQ(site.service().goals().size(), 1U);
  site.label("gate", run.place(3));
  EXPECT_EQ(site.send_goal(1, "gate").outcome, msg::Outcome::refused);
}

TEST_F(GoalLife, GoalThatARobotCouldNotLeaveAgainIsRefusedUnlessThatIsWanted) {
  msg::OperatorRequest send = site.request(Kind::goal_send);
  send.goal = goal_id(1);
  send.label = "dock";
  const msg::OperatorReply refused = site.ask(send);
  EXPECT_EQ(refused.outcome, msg::Outcome::refused);
  EXPECT_THAT(refused.message, AllOf(HasSubstr("could not leave dock again"), HasSubstr("--no-return")));
  EXPECT_EQ(site.goal(1).state, GoalState::rejected);
  // The road is closed to a round.
  TaughtRun back(r1, 99);
  Handed handed = back.next(5);
  handed.batch.edges.push_back(stitch(run.place(39), back.place(0)));
  handed.batch.edges.push_back(stitch(run.place(0), back.place(4)));
  site.hand_in(r1, handed);
  send = site.request(Kind::goal_send);
  send.goal = goal_id(2);
  send.label = "dock";
  EXPECT_EQ(site.ask(send).outcome, msg::Outcome::accepted);
}

TEST_F(GoalLife, WantedRobotIsWaitedForWithTheReason) {
  site.send_goal(1, "dock", "r1");
  EXPECT_EQ(site.goal(1).state, GoalState::pending);
  EXPECT_THAT(site.goal(1).history.back().cause, HasSubstr("does not know where it is"));
  msg::RobotState teaching = site.state(r1, run.place(0));
  teaching.mode = msg::RobotMode::teaching;
  site.say(teaching);
  site.pass(1s);
  EXPECT_THAT(site.goal(1).history.back().cause, HasSubstr("teaching"));
  site.say(site.state(r1, run.place(0)));
  site.pass(1s);
  EXPECT_EQ(site.goal(1).state, GoalState::assigned);
}

TEST_F(GoalLife, RobotTakesItsGoalsOneAfterTheOther) {
  const Route first = start();
  site.send_goal(2, "dock", "r1");
  site.say(site.driving(r1, first, run.place(3)));
  site.pass(1s);
  EXPECT_EQ(site.goal(2).state, GoalState::pending);
  EXPECT_THAT(site.goal(2).history.back().cause, HasSubstr(to_string(goal_id(1))));
  site.progress(r1, first, msg::RoutePhase::arrived, 39);
  stand(run.place(39));
  site.pass(1s);
  EXPECT_EQ(site.goal(2).state, GoalState::assigned);
  EXPECT_EQ(site.order().places.size(), 1U) << "it stands there already";
}

TEST_F(GoalLife, AnyRobotIsTheOneWithTheShortestWay) {
  Peer r2{.id = robot_id(2), .name = "r2"};
  Peer r3{.id = robot_id(3), .name = "r3"};
  site.arrive(r2, run.place(20));
  site.arrive(r3, std::nullopt);
  stand(run.place(5));
  site.send_goal(1, "dock");
  EXPECT_EQ(site.goal(1).robot, r2.id);
}

TEST_F(GoalLife, TiesGoToTheLowestId) {
  Peer r2{.id = robot_id(2), .name = "r2"};
  TaughtRun other(r2, 11);
  site.arrive(r2, std::nullopt);
  site.hand_in(r2, other.next(2));
  const Handed joined = other.next(1);
  site.hand_in(r2, joined);
  site.arrive(r2, run.place(5));
  stand(run.place(5));
  site.send_goal(1, "dock");
  EXPECT_EQ(site.goal(1).robot, r1.id);
}

TEST_F(GoalLife, RobotThatCannotDriveTheWayIsNotAsked) {
  site.label("start", run.place(0));
  stand(run.place(5));
  site.send_goal(1, "start");
  site.pass(2s);
  EXPECT_EQ(site.goal(1).state, GoalState::pending) << "edges are driven as they were taught";
  stand(run.place(0));
  site.pass(2s);
  EXPECT_EQ(site.goal(1).state, GoalState::assigned);
}

TEST_F(GoalLife, PendingGoalIsCancelled) {
  site.send_goal(1, "dock");
  EXPECT_EQ(cancel(1).outcome, msg::Outcome::done);
  EXPECT_EQ(site.goal(1).state, GoalState::cancelled);
  EXPECT_EQ(cancel(1).outcome, msg::Outcome::done);
  EXPECT_EQ(cancel(9).outcome, msg::Outcome::refused);
  stand(run.place(0));
  site.pass(2s);
  EXPECT_THAT(site.heard<msg::RouteOrder>(), IsEmpty());
}

TEST_F(GoalLife, RunningGoalIsCancelledAndWhatIsHeldStaysHeldUntilTheRobotStands) {
  const Route route = start();
  site.say(site.driving(r1, route, run.place(4)));
  EXPECT_EQ(cancel(1).outcome, msg::Outcome::done);
  EXPECT_EQ(site.goal(1).state, GoalState::cancelled);
  EXPECT_TRUE(site.order().ended);
  EXPECT_EQ(site.order().id, route.id);
  site.hush();
  site.pass(3s);
  EXPECT_FALSE(site.heard<msg::RouteOrder>().empty()) << "said again until it is obeyed";
  EXPECT_EQ(site.disk->occupancies.at(r1.id).held.id, route.id);
  site.say(site.driving(r1, route, run.place(5)));
  EXPECT_EQ(site.disk->occupancies.at(r1.id).held.id, route.id);
  stand(run.place(6));
  EXPECT_EQ(site.disk->occupancies.at(r1.id).held.places.front(), run.place(6));
  site.hush();
  site.pass(10s);
  EXPECT_THAT(site.heard<msg::RouteOrder>(), IsEmpty());
}

TEST_F(GoalLife, StopPausesAndResumeGoesOn) {
  const Route route = start();
  msg::OperatorRequest stop = site.request(Kind::stop);
  stop.robot = "r1";
  site.say(stop);
  EXPECT_EQ(site.goal(1).state, GoalState::paused);
  const msg::AgentCommand told = site.last<msg::AgentCommand>().value();
  EXPECT_EQ(told.kind, msg::AgentCommand::Kind::stop);
  site.say(msg::AgentReply{.header = r1.header(),
                           .command = told.command,
                           .done = true,
                           .reason = {},
                           .place = {},
                           .experience = {},
                           .report = {},
                           .counts = {}});
  EXPECT_EQ(site.last<msg::OperatorReply>()->outcome, msg::Outcome::done);
  site.progress(r1, route, msg::RoutePhase::stopped, 3);
  EXPECT_EQ(site.goal(1).state, GoalState::paused);
  msg::OperatorRequest resume = site.request(Kind::resume);
  resume.robot = "r1";
  site.say(resume);
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
  EXPECT_EQ(site.last<msg::AgentCommand>()->kind, msg::AgentCommand::Kind::resume);
}

TEST_F(GoalLife, PausedRobotThatDrivesIsToldAgain) {
  const Route route = start();
  msg::OperatorRequest stop = site.request(Kind::stop);
  site.say(stop);
  site.restart();
  site.arrive(r1, std::nullopt);
  site.hush();
  site.say(site.driving(r1, route, run.place(5)));
  ASSERT_TRUE(site.last<msg::AgentCommand>());
  EXPECT_EQ(site.last<msg::AgentCommand>()->kind, msg::AgentCommand::Kind::stop);
  EXPECT_EQ(site.goal(1).state, GoalState::paused);
}

TEST_F(GoalLife, CancelWhilePaused) {
  start();
  site.say(site.request(Kind::stop));
  EXPECT_EQ(cancel(1).outcome, msg::Outcome::done);
  EXPECT_EQ(site.goal(1).state, GoalState::cancelled);
}

TEST_F(GoalLife, RobotThatGivesUpFailsTheGoalWithItsReason) {
  const Route route = start();
  give_up(route, "the wheel is off");
  EXPECT_EQ(site.goal(1).state, GoalState::failed);
  EXPECT_EQ(site.goal(1).history.back().cause, "the wheel is off");
}

TEST_F(GoalLife, RobotThatCannotBendIntoItsRouteIsGivenAnotherOneOnce) {
  for (int tried = 0; tried < 2; ++tried) {
    const Route route = tried == 0 ? start() : site.last<msg::RouteOrder>()->route;
    give_up(route, "route_makes_no_path");
    if (tried == 1) break;
    EXPECT_EQ(site.goal(1).state, GoalState::executing);
    EXPECT_TRUE(site.last<msg::RouteOrder>()->route.ended);
    site.pass(4s);
    stand(run.place(3));
    site.pass(1s);
    EXPECT_NE(site.last<msg::RouteOrder>()->route.id, route.id);
    EXPECT_EQ(site.last<msg::RouteOrder>()->route.places.front(), run.place(3));
  }
  EXPECT_EQ(site.goal(1).state, GoalState::failed);
}

TEST_F(GoalLife, OrderIsRepeatedUntilTheRobotHasIt) {
  stand(run.place(0));
  site.send_goal(1, "dock");
  site.pass(4s);
  const std::size_t sent = site.heard<msg::RouteOrder>().size();
  EXPECT_GE(sent, 3U);
  const Route route = site.order();
  site.progress(r1, route, msg::RoutePhase::accepted);
  site.hush();
  site.pass(3s);
  EXPECT_THAT(site.heard<msg::RouteOrder>(), IsEmpty());
}

TEST_F(GoalLife, StateThatCannotBeStoredIsNotReached) {
  const Route route = start();
  site.disk->faults.full = true;
  site.progress(r1, route, msg::RoutePhase::arrived, 39);
  EXPECT_EQ(site.goal(1).state, GoalState::executing);
  site.disk->faults.full = false;
  site.progress(r1, route, msg::RoutePhase::arrived, 39);
  EXPECT_EQ(site.goal(1).state, GoalState::succeeded);
}

TEST_F(GoalLife, ResumeThatCannotBeStoredIsNotSaidToBeDone) {
  start();
  msg::OperatorRequest stop = site.request(Kind::stop);
  stop.robot = "r1";
  site.say(stop);
  ASSERT_EQ(site.goal(1).state, GoalState::paused);
  site.disk->faults.full = true;
  site.hush();
  msg::OperatorRequest resume = site.request(Kind::resume);
  resume.robot = "r1";
  EXPECT_EQ(site.ask(resume).outcome, msg::Outcome::failed);
  for (const msg::AgentCommand& told : site.heard<msg::AgentCommand>()) {
    EXPECT_NE(told.kind, msg::AgentCommand::Kind::resume) << "it would drive on a paused goal";
  }
  EXPECT_EQ(site.goal(1).state, GoalState::paused);
  site.disk->faults.full = false;
  msg::OperatorRequest again = site.request(Kind::resume);
  again.robot = "r1";
  site.say(again);
  EXPECT_NE(site.goal(1).state, GoalState::paused);
}

TEST_F(GoalLife, StopThatCannotBeStoredStandsAllTheSame) {
  const Route route = start();
  site.progress(r1, route, msg::RoutePhase::driving, 2);
  ASSERT_EQ(site.goal(1).state, GoalState::executing);
  site.disk->faults.full = true;
  msg::OperatorRequest stop = site.request(Kind::stop);
  stop.robot = "r1";
  site.say(stop);
  const msg::AgentCommand told = site.last<msg::AgentCommand>().value();
  ASSERT_EQ(told.kind, msg::AgentCommand::Kind::stop);
  site.say(msg::AgentReply{.header = r1.header(),
                           .command = told.command,
                           .done = true,
                           .reason = {},
                           .place = {},
                           .experience = {},
                           .report = {},
                           .counts = {}});
  site.hush();
  msg::RobotState stopped = site.driving(r1, route, run.place(3));
  stopped.mode = msg::RobotMode::stopped;
  stopped.header = r1.header();
  site.say(stopped);
  EXPECT_THAT(site.heard<msg::AgentCommand>(), IsEmpty()) << "it is not told to go on";
  site.disk->faults.full = false;
  stopped.header = r1.header();
  site.say(stopped);
  EXPECT_EQ(site.goal(1).state, GoalState::paused);
  EXPECT_THAT(site.heard<msg::AgentCommand>(), IsEmpty());
}

}  // namespace
}  // namespace weft::server::test
