#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct FleetTest : testing::Test {
  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
};

TEST_F(FleetTest, SkewIsTakenFromTheQuickestProbe) {
  site.arrive(r1, std::nullopt);
  const auto answer_probe = [&](Duration there, Duration back) {
    site.hush();
    for (int i = 0; i < 30 && site.heard<msg::ClockProbe>().empty(); ++i) {
      site.say(site.state(r1, std::nullopt));  // stays heard
      site.pass(1s);
    }
    const msg::ClockProbe probe = site.last<msg::ClockProbe>().value();
    const WallTime received = site.now.wall + there + 30s;  // its clock is 30 s ahead
    site.pass(there + back);
    site.say(msg::ClockReply{.header = r1.header(),
                             .probe = probe.probe,
                             .probe_sent = site.now.wall - there - back,
                             .received = received,
                             .replied = received});
  };
  // The probe went out up to a second before the helper saw it; quick ones win over slow and lopsided ones.
  answer_probe(800ms, 10ms);
  answer_probe(0ms, 0ms);
  answer_probe(900ms, 0ms);
  EXPECT_NEAR(site.row("r1").clock_skew_s, 30.0, 0.5);
}

TEST_F(FleetTest, SilenceIsToldOnceAndEndsWithAWord) {
  site.arrive(r1, std::nullopt);
  site.pass(20s);
  EXPECT_THAT(site.events_of("robot.silent"), SizeIs(1));
  EXPECT_NEAR(site.row("r1").silent_s, 20.0, 0.1);
  site.say(site.state(r1, std::nullopt));
  EXPECT_THAT(site.events_of("robot.heard"), SizeIs(2));
}

TEST_F(FleetTest, AnAgentThatWasEndedIsNotWaitedFor) {
  TaughtRun run(r1, 10);
  site.arrive(r1, std::nullopt);
  site.hand_in(r1, run.next(3));
  msg::RobotState last = site.state(r1, run.place(2));
  last.mode = msg::RobotMode::off;
  site.say(last);
  site.pass(0s);
  ASSERT_THAT(site.events_of("robot.silent"), SizeIs(1));
  EXPECT_THAT(site.events_of("robot.silent").front(), HasSubstr("its agent was ended"));
  msg::OperatorRequest clear = site.request(msg::OperatorRequest::Kind::clear);
  clear.robot = "r1";
  EXPECT_EQ(site.ask(clear).outcome, msg::Outcome::done) << "its place is free at once";
  r1.incarnation = 2;
  r1.sequence = 0;
  site.arrive(r1, std::nullopt);
  EXPECT_THAT(site.events_of("robot.heard"), SizeIs(2));
  site.pass(1s);
  EXPECT_THAT(site.events_of("robot.silent"), SizeIs(1));
}

TEST_F(FleetTest, RestartedAgentIsNoAlarm) {
  site.arrive(r1, std::nullopt);
  site.pass(1s);
  r1.incarnation = 2;
  r1.sequence = 0;
  site.arrive(r1, std::nullopt);
  site.pass(10s);
  site.say(site.state(r1, std::nullopt));
  EXPECT_THAT(site.events_of("robot.twins"), IsEmpty());
}

TEST_F(FleetTest, TwoLiveIncarnationsAreBothHeldAndAnAlarmSaysSo) {
  TaughtRun run(r1, 10);
  site.arrive(r1, std::nullopt);
  site.hand_in(r1, run.next(20));
  site.label("dock", run.place(19));
  site.say(site.state(r1, run.place(0)));
  site.send_goal(1, "dock", "r1");
  Peer twin = r1;
  twin.incarnation = 2;
  for (int i = 0; i < 8; ++i) {
    site.say(site.state(r1, run.place(0)));
    site.say(site.state(twin, run.place(0)));
    site.pass(1s);
  }
  EXPECT_THAT(site.events_of("robot.twins"), SizeIs(1));
  EXPECT_EQ(site.goal(1).state, GoalState::paused);
  EXPECT_EQ(site.last<msg::AgentCommand>()->kind, msg::AgentCommand::Kind::stop);
  msg::OperatorRequest resume = site.request(msg::OperatorRequest::Kind::resume);
  resume.robot = "r1";
  EXPECT_THAT(site.ask(resume).message, HasSubstr("runs twice"));
  EXPECT_EQ(site.goal(1).state, GoalState::paused);
  for (int i = 0; i < 8; ++i) {
    site.say(site.state(twin, run.place(0)));
    site.pass(1s);
  }
  EXPECT_THAT(site.events_of("robot.twins_ended"), SizeIs(1));
}

TEST_F(FleetTest, PeerWithoutACommonProtocolIsRefusedByName) {
  msg::Hello hello;
  hello.peer = r1.id;
  hello.incarnation = 1;
  hello.name = "r1";
  hello.protocol_min = 9;
  hello.protocol_max = 12;
  site.say(hello);
  ASSERT_THAT(site.events_of("peer.refused"), SizeIs(1));
  EXPECT_THAT(site.events_of("peer.refused").front(), HasSubstr("9 to 12"));
  TaughtRun run(r1, 10);
  site.hand_in(r1, run.next(2));
  EXPECT_EQ(site.service().snapshot().place_count(), 0U);
}

TEST_F(FleetTest, NameOfTwoRobotsIsRefusedWithBothIds) {
  Peer other{.id = robot_id(2), .name = "r1"};
  site.arrive(r1, std::nullopt);
  site.arrive(other, std::nullopt);
  msg::OperatorRequest stop = site.request(msg::OperatorRequest::Kind::localise);
  stop.robot = "r1";
  const msg::OperatorReply reply = site.ask(stop);
  EXPECT_EQ(reply.outcome, msg::Outcome::refused);
  EXPECT_THAT(reply.message, HasSubstr(to_string(r1.id)));
  EXPECT_THAT(reply.message, HasSubstr(to_string(other.id)));
}

TEST_F(FleetTest, AnotherServerOnTheStoreEndsThisOne) {
  site.arrive(r1, std::nullopt);
  const auto other = storage::make_memory_store(site.disk);
  ASSERT_TRUE(other->open());
  EXPECT_FALSE(site.service().broken());
  site.pass(20s);  // an event is to be written
  ASSERT_TRUE(site.service().broken());
  EXPECT_EQ(site.service().broken()->code, ErrorCode::stale);
}

}  // namespace
}  // namespace weft::server::test
