#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using Kind = msg::OperatorRequest::Kind;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct OperatorRequests : testing::Test {
  OperatorRequests() {
    site.arrive(r1, std::nullopt);
    site.hand_in(r1, run.next(4));
    site.hush();
  }
  msg::AgentCommand command() { return site.last<msg::AgentCommand>().value(); }
  void answer(const msg::AgentCommand& to, bool done, const std::string& reason = "", PlaceId place = {}) {
    site.say(msg::AgentReply{.header = r1.header(),
                             .command = to.command,
                             .done = done,
                             .reason = reason,
                             .place = place,
                             .experience = {},
                             .report = {},
                             .counts = {}});
  }
  std::optional<msg::OperatorReply> reply() { return site.last<msg::OperatorReply>(); }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  TaughtRun run{r1, 10};
};

TEST_F(OperatorRequests, CommandGoesToTheRobotAndItsAnswerToTheOperator) {
  msg::OperatorRequest teach = site.request(Kind::teach_start);
  teach.robot = "r1";
  teach.label = "loop";
  site.say(teach);
  EXPECT_FALSE(reply());
  EXPECT_EQ(command().kind, msg::AgentCommand::Kind::teach_start);
  EXPECT_EQ(command().name, "loop");
  answer(command(), true);
  EXPECT_EQ(reply()->outcome, msg::Outcome::done);
}

TEST_F(OperatorRequests, ReportIsAskedOfTheRobotAndPassedOn) {
  msg::OperatorRequest wanted = site.request(Kind::teach_report);
  wanted.robot = "r1";
  wanted.label = "loop";
  site.say(wanted);
  EXPECT_EQ(command().kind, msg::AgentCommand::Kind::teach_report);
  EXPECT_EQ(command().name, "loop");
  msg::AgentReply reported{r1.header(), command().command, true, "", {}, run.id(), {}, {}};
  reported.report = {{0.0, 9.5, 48, run.place(0), {{"as_is", 0.75, 0.1, 0.5}}, 0.004, "few_inliers"}};
  site.say(reported);
  EXPECT_EQ(reply()->outcome, msg::Outcome::done);
  EXPECT_EQ(reply()->report, reported.report);
  EXPECT_EQ(reply()->experience, run.id());
}

TEST_F(OperatorRequests, CountsAreAskedOfTheRobotPassedOnAndLeaveNoEvent) {
  const std::size_t before = site.disk->events.size();
  msg::OperatorRequest wanted = site.request(Kind::robot_counts);
  wanted.robot = "r1";
  site.say(wanted);
  EXPECT_EQ(command().kind, msg::AgentCommand::Kind::counts);
  msg::AgentReply counted{r1.header(), command().command, true, "", {}, {}, {}, {}};
  counted.counts = {{"navigation: few_matches", 3}, {"navigation: fixes", 70}};
  site.say(counted);
  EXPECT_EQ(reply()->outcome, msg::Outcome::done);
  EXPECT_EQ(reply()->counts, counted.counts);
  EXPECT_EQ(site.disk->events.size(), before);
}

TEST_F(OperatorRequests, CommandIsRepeatedUntilAnsweredAndTheRequestDoneOnce) {
  msg::OperatorRequest localise = site.request(Kind::localise);
  localise.robot = "r1";
  site.say(localise);
  site.pass(2s);
  site.say(localise);
  const std::vector<msg::AgentCommand> sent = site.heard<msg::AgentCommand>();
  EXPECT_GE(sent.size(), 2U);
  for (const msg::AgentCommand& one : sent) EXPECT_EQ(one.command, sent.front().command);
  answer(command(), false, "nothing known is in view");
  EXPECT_EQ(reply()->outcome, msg::Outcome::refused);
  EXPECT_THAT(reply()->message, HasSubstr("nothing known is in view"));
  site.hush();
  site.say(localise);
  EXPECT_THAT(reply()->message, HasSubstr("nothing known is in view"));
  EXPECT_THAT(site.heard<msg::AgentCommand>(), IsEmpty());
}

TEST_F(OperatorRequests, PolylineNeedsABodyWithAHand) {
  msg::OperatorRequest teach = site.request(Kind::teach_start);
  teach.robot = "r1";
  teach.along = {{0, 0}, {1, 0}};
  EXPECT_EQ(site.ask(teach).outcome, msg::Outcome::refused);
  EXPECT_THAT(site.heard<msg::AgentCommand>(), IsEmpty());
}

TEST_F(OperatorRequests, SilentRobotIsRefusedAtOnceAndOneThatFallsSilentLater) {
  msg::OperatorRequest localise = site.request(Kind::localise);
  localise.robot = "r1";
  site.say(localise);
  site.pass(20s);
  EXPECT_EQ(reply()->outcome, msg::Outcome::failed);
  msg::OperatorRequest again = site.request(Kind::localise);
  again.robot = "r1";
  EXPECT_EQ(site.ask(again).outcome, msg::Outcome::refused);
}

TEST_F(OperatorRequests, LabelIsSetMovedAndChecked) {
  site.label("dock", run.place(1));
  EXPECT_EQ(site.service().snapshot().labels().at("dock"), run.place(1));
  site.label("dock", run.place(2));
  EXPECT_EQ(site.service().snapshot().labels().at("dock"), run.place(2));
  msg::OperatorRequest wrong = site.request(Kind::label);
  wrong.label = "no spaces";
  wrong.place = run.place(1);
  EXPECT_EQ(site.ask(wrong).outcome, msg::Outcome::refused);
  wrong = site.request(Kind::label);
  wrong.label = "far";
  wrong.place = run.place(77);
  EXPECT_EQ(site.ask(wrong).outcome, msg::Outcome::refused);
  site.restart();
  EXPECT_EQ(site.service().snapshot().labels().at("dock"), run.place(2));
}

TEST_F(OperatorRequests, ALabelThatTheStoreDoesNotTakeHasFailed) {
  site.disk->faults.full = true;
  msg::OperatorRequest dock = site.request(Kind::label);
  dock.label = "dock";
  dock.place = run.place(1);
  EXPECT_EQ(site.ask(dock).outcome, msg::Outcome::failed);
  EXPECT_FALSE(site.service().snapshot().labels().contains("dock"));
  site.disk->faults.full = false;
}

TEST_F(OperatorRequests, LabelHereTakesThePlaceOnWhichTheRobotStands) {
  site.say(site.state(r1, run.place(3)));
  msg::OperatorRequest here = site.request(Kind::label_here);
  here.robot = "r1";
  here.label = "dock";
  EXPECT_EQ(site.ask(here).place, run.place(3));
  EXPECT_EQ(site.service().snapshot().labels().at("dock"), run.place(3));
}

TEST_F(OperatorRequests, LabelHereWaitsUntilTheKeptPlaceIsOnDisk) {
  msg::OperatorRequest here = site.request(Kind::label_here);
  here.robot = "r1";
  here.label = "dock";
  site.say(here);
  EXPECT_EQ(command().kind, msg::AgentCommand::Kind::keep_place);
  answer(command(), true, "", run.place(4));
  EXPECT_FALSE(reply());
  site.hand_in(r1, run.next(1));
  EXPECT_EQ(reply()->outcome, msg::Outcome::done);
  EXPECT_EQ(site.service().snapshot().labels().at("dock"), run.place(4));
}

TEST_F(OperatorRequests, WhoeverWaitsForAKeptPlaceIsToldSoUntilItComes) {
  msg::OperatorRequest here = site.request(Kind::label_here);
  here.robot = "r1";
  here.label = "dock";
  site.say(here);
  answer(command(), true, "", run.place(4));
  site.say(site.state(r1, run.place(3)));
  EXPECT_FALSE(reply());
  site.pass(11s);
  EXPECT_EQ(reply()->outcome, msg::Outcome::under_way);
  EXPECT_THAT(reply()->message, HasSubstr("becomes dock when the robot hands it in"));
  site.hand_in(r1, run.next(1));
  EXPECT_EQ(reply()->outcome, msg::Outcome::done);
}

TEST_F(OperatorRequests, TwoLabelsOfOneKeptPlaceAreBothSetAndAnswered) {
  for (const std::string label : {"dock", "charger"}) {
    msg::OperatorRequest here = site.request(Kind::label_here);
    here.robot = "r1";
    here.label = label;
    site.say(here);
    answer(command(), true, "", run.place(4));
  }
  site.hand_in(r1, run.next(1));
  const auto labels = site.service().snapshot().labels();
  EXPECT_EQ(labels.at("dock"), run.place(4));
  EXPECT_EQ(labels.at("charger"), run.place(4));
  std::size_t done = 0;
  for (const msg::OperatorReply& one : site.heard<msg::OperatorReply>()) done += one.outcome == msg::Outcome::done;
  EXPECT_GE(done, 2U);
}

TEST_F(OperatorRequests, StopOvertakesAndResumeDoesNot) {
  msg::OperatorRequest localise = site.request(Kind::localise);
  localise.robot = "r1";
  site.say(localise);
  site.say(site.request(Kind::stop));
  site.say(site.request(Kind::resume));
  std::vector<msg::AgentCommand::Kind> kinds;
  for (const msg::AgentCommand& one : site.heard<msg::AgentCommand>()) kinds.push_back(one.kind);
  using Agent = msg::AgentCommand::Kind;
  EXPECT_THAT(kinds, testing::ElementsAre(Agent::localise, Agent::stop));
  const std::vector<msg::AgentCommand> sent = site.heard<msg::AgentCommand>();
  answer(sent[0], true);
  answer(sent[1], true);
  EXPECT_EQ(command().kind, Agent::resume);
}

TEST_F(OperatorRequests, AnswersToQueriesCarryEverything) {
  site.label("dock", run.place(1));
  msg::Query query;
  query.header = site.client.header();
  query.request = 5;
  query.kind = msg::Query::Kind::info;
  site.say(query);
  const msg::MapInfo info = site.last<msg::QueryReply>()->info;
  EXPECT_EQ(info.places, 4U);
  EXPECT_EQ(info.experiences, 1U);
  EXPECT_EQ(info.contents, 4U);
  EXPECT_EQ(info.batches_acknowledged, 1U);
  EXPECT_EQ(info.revision, site.service().snapshot().revision());
  query.kind = msg::Query::Kind::events;
  site.say(query);
  EXPECT_FALSE(site.last<msg::QueryReply>()->events.empty());
}

}  // namespace
}  // namespace weft::server::test
