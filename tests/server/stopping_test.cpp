#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using Kind = msg::OperatorRequest::Kind;
using testing::HasSubstr;
using testing::SizeIs;
using testing::StartsWith;

struct Stopping : testing::Test {
  Stopping() {
    site.arrive(r1, std::nullopt);
    site.arrive(r2, std::nullopt);
    site.hush();
  }
  void confirm(Peer& robot) {
    for (const msg::AgentCommand& command : site.heard<msg::AgentCommand>()) {
      if (command.to != robot.id) continue;
      msg::AgentReply reply;
      reply.header = robot.header();
      reply.command = command.command;
      reply.done = true;
      site.say(reply);
    }
  }
  std::optional<msg::OperatorReply> reply() { return site.last<msg::OperatorReply>(); }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  Peer r2{.id = robot_id(2), .name = "r2"};
  TaughtRun run{r1, 10};
};

TEST_F(Stopping, AllIsDoneWhenEachRobotHasConfirmed) {
  site.say(site.request(Kind::stop));
  confirm(r1);
  EXPECT_FALSE(reply());
  confirm(r2);
  EXPECT_EQ(reply()->outcome, msg::Outcome::done);
  EXPECT_EQ(reply()->message, "2 of 2 robots stand");
  EXPECT_THAT(reply()->findings, testing::UnorderedElementsAre(StartsWith("r1: stands"), StartsWith("r2: stands")));
}

TEST_F(Stopping, ARobotThatHasJustDiedDoesNotKeepTheOperatorWaiting) {
  site.say(site.request(Kind::stop));
  confirm(r1);
  site.pass(1600ms);  // r2 does not count as silent yet
  ASSERT_TRUE(reply());
  EXPECT_EQ(reply()->outcome, msg::Outcome::failed);
  EXPECT_THAT(reply()->message, HasSubstr("1 of 2 robots stand"));
  ASSERT_THAT(reply()->findings, SizeIs(2));
  EXPECT_THAT(reply()->findings[0], HasSubstr("r2: not heard for 1.5 s"));
  EXPECT_THAT(reply()->findings[1], StartsWith("r1: stands"));
}

TEST_F(Stopping, TheGoalOfADeadRobotIsPausedAndItsReachNamed) {
  site.hand_in(r1, run.next(20));
  site.label("dock", run.place(19));
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "dock", "r1");
  site.say(site.request(Kind::stop));
  confirm(r2);
  site.pass(2s);
  EXPECT_EQ(site.goal(1).state, GoalState::paused);
  EXPECT_THAT(reply()->findings[0], HasSubstr("drives no farther than place " + to_string(run.place(19))));
}

TEST_F(Stopping, ASilentRobotIsNotWaitedForAndToldWhenItIsHeard) {
  site.pass(20s);
  site.hush();
  msg::OperatorRequest stop = site.request(Kind::stop);
  stop.robot = "r2";
  site.say(stop);
  EXPECT_EQ(reply()->outcome, msg::Outcome::failed);
  EXPECT_THAT(reply()->message, HasSubstr("r2: not heard for 20.0 s; it is told when it is heard"));
  site.hush();
  site.pass(4s);
  EXPECT_EQ(site.last<msg::AgentCommand>()->kind, msg::AgentCommand::Kind::stop);
}

TEST_F(Stopping, ALateConfirmationChangesNoAnswerAndARepeatGetsTheSame) {
  const msg::OperatorRequest stop = site.request(Kind::stop);
  site.say(stop);
  site.pass(2s);
  const std::string said = reply()->message;
  confirm(r1);
  confirm(r2);
  site.hush();
  site.say(stop);
  EXPECT_EQ(reply()->message, said);
}

}  // namespace
}  // namespace weft::server::test
