#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using Kind = msg::OperatorRequest::Kind;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// Arranges a robot, and the one with another identity that took over its name.
struct Roster : testing::Test {
  Site site;
  Peer old{.id = robot_id(1), .name = "r1"};
  Peer replaced{.id = robot_id(2), .name = "r1"};

  msg::OperatorReply ask(Kind kind, const std::string& robot, const std::string& name = "") {
    msg::OperatorRequest request = site.request(kind);
    request.robot = robot;
    request.label = name;
    return site.ask(request);
  }
  /// Returns which robots a stop goes to.
  std::vector<RobotId> stopped(const std::string& robot) {
    site.hush();
    msg::OperatorRequest request = site.request(Kind::stop);
    request.robot = robot;
    site.say(request);
    std::vector<RobotId> told;
    for (const msg::AgentCommand& command : site.heard<msg::AgentCommand>()) told.push_back(command.to);
    return told;
  }
  std::vector<std::string> names() {
    site.hush();
    msg::Query query;
    query.header = site.client.header();
    query.request = 77;
    query.kind = msg::Query::Kind::robots;
    site.say(query);
    std::vector<std::string> names;
    for (const msg::QueryReply& reply : site.heard<msg::QueryReply>()) {
      for (const msg::RobotRow& row : reply.robots) names.push_back(row.description.name);
    }
    return names;
  }
  void old_falls_silent() {
    site.arrive(old, std::nullopt);
    site.pass(10s);
  }
};

TEST_F(Roster, GoalsForAForgottenRobotFail) {
  TaughtRun run{old, 50};
  site.arrive(old, std::nullopt);
  site.hand_in(old, run.next(3));
  site.label("dock", run.place(2));
  site.pass(10s);
  site.send_goal(1, "dock", "r1");
  site.pass(1s);
  ASSERT_EQ(site.goal(1).state, GoalState::pending);
  EXPECT_EQ(ask(Kind::forget, "r1").outcome, msg::Outcome::done);
  EXPECT_EQ(site.goal(1).state, GoalState::failed);
  EXPECT_THAT(site.goal(1).history.back().cause, HasSubstr("was forgotten"));
}

TEST_F(Roster, AnImportWhoseBatchOvertakesItsHelloIsNoRobot) {
  Peer importing{.id = robot_id(9), .name = "anna"};
  TaughtRun run{importing, 50};
  site.hand_in(importing, run.next(3));
  EXPECT_EQ(site.service().snapshot().place_count(), 3U);
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(Roster, ANameMeansTheRobotThatIsHeard) {
  old_falls_silent();
  site.arrive(replaced, std::nullopt);
  EXPECT_THAT(stopped("r1"), ElementsAre(replaced.id));
}

TEST_F(Roster, TwoThatAreHeardAreNamedWithTheirIds) {
  site.arrive(old, std::nullopt);
  site.arrive(replaced, std::nullopt);
  const msg::OperatorReply reply = ask(Kind::stop, "r1");
  EXPECT_EQ(reply.outcome, msg::Outcome::refused);
  EXPECT_THAT(reply.message, HasSubstr(to_string(old.id)));
  EXPECT_THAT(reply.message, HasSubstr(to_string(replaced.id)));
  EXPECT_THAT(stopped(to_string(replaced.id)), ElementsAre(replaced.id));
}

TEST_F(Roster, WhereNoneIsHeardTheOneThatIsGoneCanBeForgotten) {
  old_falls_silent();
  site.arrive(replaced, std::nullopt);
  site.pass(10s);
  const msg::OperatorReply unclear = ask(Kind::clear, "r1");
  EXPECT_EQ(unclear.outcome, msg::Outcome::refused);
  EXPECT_THAT(unclear.message, HasSubstr("weft robot forget"));
  EXPECT_EQ(ask(Kind::forget, to_string(old.id)).outcome, msg::Outcome::done);
  EXPECT_THAT(names(), ElementsAre("r1"));
  EXPECT_EQ(ask(Kind::clear, "r1").outcome, msg::Outcome::done);
  EXPECT_THAT(site.events_of("robot.forgotten"), SizeIs(1));
  site.restart();
  EXPECT_THAT(names(), ElementsAre("r1"));
}

TEST_F(Roster, WhatAForgottenRobotTaughtStaysAndItMayComeBack) {
  TaughtRun run(old, 10);
  site.arrive(old, std::nullopt);
  site.hand_in(old, run.next(5));
  site.say(site.state(old, run.place(4)));
  site.pass(10s);
  EXPECT_EQ(ask(Kind::forget, "r1").outcome, msg::Outcome::done);
  EXPECT_THAT(names(), IsEmpty());
  EXPECT_NE(site.service().snapshot().place(run.place(4)), nullptr);
  site.arrive(old, run.place(4));
  EXPECT_THAT(names(), ElementsAre("r1"));
}

TEST_F(Roster, ARobotThatIsHeardIsNeitherForgottenNorRenamed) {
  site.arrive(old, std::nullopt);
  EXPECT_EQ(ask(Kind::forget, "r1").outcome, msg::Outcome::refused);
  EXPECT_EQ(ask(Kind::rename, "r1", "r9").outcome, msg::Outcome::refused);
  EXPECT_THAT(names(), ElementsAre("r1"));
}

TEST_F(Roster, ARobotThatIsSilentGetsANameThatIsFree) {
  old_falls_silent();
  Peer other{.id = robot_id(3), .name = "r3"};
  site.arrive(other, std::nullopt);
  EXPECT_THAT(ask(Kind::rename, "r1", "r3").message, HasSubstr("named r3 already"));
  EXPECT_THAT(ask(Kind::rename, "r1", "r 1").message, HasSubstr("the character U+0020"));
  EXPECT_EQ(ask(Kind::rename, "r1", "r1-alt").outcome, msg::Outcome::done);
  EXPECT_THAT(names(), ElementsAre("r1-alt", "r3"));
  site.restart();
  EXPECT_THAT(names(), ElementsAre("r1-alt", "r3"));
  site.arrive(old, std::nullopt);
  EXPECT_THAT(names(), ElementsAre("r1", "r3")) << "its agent says what it is called";
}

TEST_F(Roster, AnUnknownNameListsThoseThatThereAre) {
  EXPECT_THAT(ask(Kind::stop, "r7").message, HasSubstr("none was ever heard"));
  Peer other{.id = robot_id(3), .name = "a3"};
  site.arrive(old, std::nullopt);
  site.arrive(other, std::nullopt);
  EXPECT_THAT(ask(Kind::stop, "r7").message, HasSubstr("known: a3, r1"));
}

TEST_F(Roster, WhoAskedIsWhatTheRequestSays) {
  site.arrive(old, std::nullopt);
  msg::OperatorRequest request = site.request(Kind::stop);
  request.header.sender = robot_id(201);  // whose hello has not come yet
  request.robot = "r1";
  request.who = "J\xFCrgen";
  site.say(request);
  ASSERT_FALSE(site.disk->events.empty());
  EXPECT_EQ(site.disk->events.back().who, "J\xEF\xBF\xBDrgen");
  request.request = 78;
  request.who = std::string(64, '\xFC');
  site.say(request);
  EXPECT_LE(site.disk->events.back().who.size(), 64U) << "longer ones cannot be read by any client";
}

}  // namespace
}  // namespace weft::server::test
