#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/agents/agent/rig.hpp"

/// Tests how a robot tells who is the server: an epoch that is only claimed decides nothing.
namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;
using testing::Contains;
using testing::HasSubstr;

constexpr Epoch kHighest{std::numeric_limits<std::uint64_t>::max()};

/// Makes a hello said once by nobody who is there: another site's server, an old message, a mistake.
msg::Hello stray_hello(const Rig& rig) {
  msg::Hello stray = rig.server.hello();
  stray.peer.bytes[0] = 66;
  stray.incarnation = 666;
  stray.epoch = kHighest;
  return stray;
}

struct Claims : testing::Test {
  Claims() {
    rig.run(4s);
    rig.log.clear();
    rig.seen.notes.clear();
  }
  /// Expects that the server is obeyed, and spoken to in its epoch.
  void expect_the_server_is_obeyed(std::uint64_t command) {
    rig.tell(rig.command(msg::AgentCommand::Kind::stop, command));
    ASSERT_FALSE(rig.sent<msg::AgentReply>().empty());
    EXPECT_EQ(rig.sent<msg::AgentReply>().back().command, command);
    EXPECT_EQ(rig.sent<msg::AgentReply>().back().header.epoch, rig.server.epoch);
  }
  Rig rig;
};

TEST_F(Claims, AStrayHelloChangesNothingAndIsSaid) {
  rig.tell(stray_hello(rig));
  expect_the_server_is_obeyed(1);
  rig.run(10s);
  expect_the_server_is_obeyed(2);
  EXPECT_THAT(rig.seen.notes, Contains(HasSubstr("epoch 18446744073709551615 and did not answer")));
  EXPECT_EQ(rig.agent->counters().at("server: a claim that nobody confirmed"), 1U);
}

TEST_F(Claims, AStrayHeaderChangesNothingAndIsNotObeyed) {
  msg::AgentCommand stray = rig.command(msg::AgentCommand::Kind::stop, 9);
  stray.header.epoch = kHighest;
  stray.header.incarnation = 666;
  rig.tell(stray);
  EXPECT_TRUE(rig.sent<msg::AgentReply>().empty());
  rig.run(10s);
  expect_the_server_is_obeyed(1);
}

TEST_F(Claims, AStrayThatRepeatsAnOldAnswerIsNotBelieved) {
  rig.run(20s);  // its hello is repeated every 15 s
  ASSERT_FALSE(rig.sent<msg::Hello>().empty());
  msg::Hello stray = stray_hello(rig);
  stray.answers = {rig.last<msg::Hello>()->challenge};
  rig.tell(stray);
  rig.tell(stray);
  expect_the_server_is_obeyed(1);
  EXPECT_NE(rig.last<msg::Hello>()->challenge, stray.answers.front()) << "each claim is asked with a new number";
}

TEST_F(Claims, ARestartedServerIsTakenAtOnce) {
  rig.server.restart();
  rig.tell(rig.server.hello());
  expect_the_server_is_obeyed(1);
}

TEST_F(Claims, ARestartedServerIsTakenBesideAStrayAndThroughLosses) {
  rig.tell(stray_hello(rig));
  rig.server.restart();
  int lost = 0;
  rig.lost_up = [&](const msg::Message& message) {
    return std::holds_alternative<msg::Hello>(message) && ++lost <= 2;
  };
  rig.tell(rig.server.hello());
  rig.run(2s);
  expect_the_server_is_obeyed(1);
  rig.run(10s);
  expect_the_server_is_obeyed(2);
}

TEST_F(Claims, TheFirstServerThatIsHeardShowsThatItLivesToo) {
  rig.connected = false;
  rig.restart_agent();
  rig.log.clear();
  rig.tell(stray_hello(rig));
  rig.run(5s);
  EXPECT_EQ(rig.last<msg::RobotState>()->header.epoch, Epoch{});
  rig.connected = true;
  rig.run(5s);
  expect_the_server_is_obeyed(1);
}

TEST_F(Claims, AStrayOfAnotherProtocolIsNoReasonToStopWorking) {
  msg::Hello stray = stray_hello(rig);
  stray.protocol_min = stray.protocol_max = 9;
  rig.tell(stray);
  rig.run(4s);
  EXPECT_EQ(rig.last<msg::RobotState>()->reason, "");
}

TEST_F(Claims, ManyStraysKeepNoRealServerOut) {
  for (std::uint64_t i = 0; i < 20; ++i) {
    msg::Hello stray = stray_hello(rig);
    stray.incarnation += i;
    rig.tell(stray);
  }
  rig.server.restart();
  rig.tell(rig.server.hello());
  expect_the_server_is_obeyed(1);
}

}  // namespace
}  // namespace weft::agents::test
