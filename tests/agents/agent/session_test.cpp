#include "agents/agent/session.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

TEST(Session, LowerEpochIsRefusedAndCounted) {
  Rig rig;
  rig.server.epoch = Epoch{5};
  rig.tell(rig.server.hello());
  rig.server.epoch = Epoch{4};
  rig.tell(rig.command(msg::AgentCommand::Kind::stop, 1));
  EXPECT_TRUE(rig.sent<msg::AgentReply>().empty());
  EXPECT_EQ(rig.agent->counters().at("server: epoch lower than heard before"), 1U);
}

TEST(Session, TwoServersInOneEpochAreNotBothBelieved) {
  Rig rig;
  rig.tell(rig.server.hello());
  rig.server.incarnation = 12;
  rig.tell(rig.server.hello());
  EXPECT_EQ(rig.agent->counters().at("server: a second one in the same epoch"), 1U);
}

TEST(Session, NoProtocolInCommonIsSaidInTheState) {
  Rig rig;
  rig.run(1s);
  msg::Hello newer = rig.server.hello();
  newer.protocol_min = 2;
  newer.protocol_max = 3;
  rig.tell(newer);
  rig.run(1s);
  EXPECT_NE(rig.last<msg::RobotState>()->reason.find("protocol 2 to 3"), std::string::npos);
}

TEST(Session, HeadersCountUpAndCarryTheServersEpoch) {
  Rig rig;
  rig.server.epoch = Epoch{9};
  rig.tell(rig.server.hello());
  rig.run(5s);
  const auto states = rig.sent<msg::RobotState>();
  ASSERT_GE(states.size(), 2U);
  EXPECT_EQ(states.back().header.epoch, Epoch{9});
  EXPECT_EQ(states.back().header.sender, rig.robot);
  EXPECT_EQ(states.back().header.incarnation, 1U);
  EXPECT_GT(states.back().header.sequence, states.front().header.sequence);
}

TEST(Session, RestartedServerIsToldEverythingAgain) {
  Rig rig;
  rig.tell(rig.server.hello());
  rig.run(5s);
  rig.log.clear();
  rig.server.restart();
  rig.tell(rig.server.hello());
  EXPECT_EQ(rig.sent<msg::Hello>().size(), 1U);
  EXPECT_EQ(rig.sent<msg::RobotDescription>().size(), 1U);
  EXPECT_EQ(rig.sent<msg::RobotState>().size(), 1U);
  rig.run(300ms);
  EXPECT_EQ(rig.sent<msg::WindowRequest>().size(), 1U);
}

TEST(Session, OrdersMeantForAnEarlierIncarnationAreNotCarriedOut) {
  Rig rig;
  const ExperienceId laid = rig.lay_out(70, 5);
  const msg::RouteOrder late = rig.order(a_route(laid, 5, 1));
  rig.tell(rig.server.hello());
  rig.run(1s);  // The window is asked for and answered by now.
  rig.tell(late);
  EXPECT_FALSE(rig.agent->route().has_value());
  rig.tell(rig.order(a_route(laid, 5, 1)));
  EXPECT_TRUE(rig.agent->route().has_value());
}

TEST(Session, ClockProbesAreAnsweredWithBothTimes) {
  Rig rig;
  rig.tell(rig.server.hello());
  msg::ClockProbe probe;
  probe.probe = 42;
  probe.sent = WallTime{3s};
  rig.tell(rig.server.say(probe));
  const auto reply = rig.last<msg::ClockReply>();
  ASSERT_TRUE(reply.has_value());
  EXPECT_EQ(reply->probe, 42U);
  EXPECT_EQ(reply->probe_sent, WallTime{3s});
  EXPECT_EQ(reply->received, WallTime{1s});
}

TEST(Session, MessagesForAnotherRobotAreNotOurs) {
  Rig rig;
  rig.run(4s);
  msg::AgentCommand command = rig.command(msg::AgentCommand::Kind::stop, 1);
  command.to.bytes[0] = 1;
  rig.tell(command);
  EXPECT_TRUE(rig.sent<msg::AgentReply>().empty());
}

TEST(Session, IdleRobotSaysLittle) {
  Rig rig;
  rig.tell(rig.server.hello());
  rig.run(10s);
  rig.log.clear();
  rig.run(60s);
  EXPECT_LE(rig.log.size(), 40U);
  EXPECT_GE(rig.sent<msg::RobotState>().size(), 19U);
}

TEST(Session, BadSettingsAreNamed) {
  Rig rig;
  AgentConfig config = rig.config;
  config.name = "r 1";
  const auto started = start(config, make_navigator(rig.script), *rig.spool, Random(1), rig.now);
  ASSERT_FALSE(started.has_value());
  EXPECT_NE(started.error().message.find(R"(robot "r 1" has the character U+0020)"), std::string::npos);
}

}  // namespace
}  // namespace weft::agents::test
