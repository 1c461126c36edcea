#include "agents/agent/safety_stop.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;
using Kind = msg::AgentCommand::Kind;

TEST(SafetyStop, AProtectiveStopEndsWhenTheBaseAllowsAndAFixHasCome) {
  SafetyStop stop;
  EXPECT_FALSE(stop.take(Safety::ok));
  EXPECT_TRUE(stop.take(Safety::protective_stop));
  EXPECT_FALSE(stop.take(Safety::protective_stop)) << "it goes on";
  stop.fixed();
  EXPECT_TRUE(stop.keeps_from_driving()) << "seen while it stood there";
  EXPECT_FALSE(stop.take(Safety::ok));
  EXPECT_FALSE(stop.holds());
  EXPECT_TRUE(stop.keeps_from_driving());
  EXPECT_NE(stop.reason("r1").find("seen where it is"), std::string::npos);
  stop.fixed();
  EXPECT_FALSE(stop.keeps_from_driving());
  EXPECT_EQ(stop.reason("r1"), "");
}

TEST(SafetyStop, AnEmergencyStopNeedsAPersonBesides) {
  SafetyStop stop;
  EXPECT_TRUE(stop.take(Safety::emergency_stop));
  EXPECT_FALSE(stop.resume()) << "it is pressed still";
  stop.take(Safety::ok);
  stop.fixed();
  EXPECT_TRUE(stop.holds());
  EXPECT_EQ(stop.shown(), Safety::emergency_stop);
  EXPECT_NE(stop.reason("r1").find("weft resume r1"), std::string::npos);
  EXPECT_TRUE(stop.resume());
  EXPECT_FALSE(stop.holds());
  EXPECT_TRUE(stop.keeps_from_driving());
  stop.fixed();
  EXPECT_FALSE(stop.keeps_from_driving());
  EXPECT_EQ(stop.shown(), Safety::ok);
}

TEST(SafetyStop, ASlowerBaseDrives) {
  SafetyStop stop;
  EXPECT_FALSE(stop.take(Safety::speed_limited));
  EXPECT_FALSE(stop.keeps_from_driving());
  EXPECT_EQ(stop.shown(), Safety::speed_limited);
}

/// Arranges a localised robot that drives a route of ten places.
struct Stopped : Rig {
  Stopped() : laid(lay_out(70, 10)) {
    script->estimate = Estimate{{laid, 0}, Relation{}, 0.0};
    tell(server.hello());
    run(4s);
    tell(order(a_route(laid, 10, 1)));
    script->answer.following = Following::driving;
    script->answer.command = {0.5, 0.0};
    run(1s);
  }
  void see() {
    script->answer.fix = Fix{};
    run(kFrame);
    script->answer.fix.reset();
  }
  msg::RobotState state() const { return last<msg::RobotState>().value(); }
  ExperienceId laid;
};

TEST(AgentSafety, ARobotThatItsBaseStopsStandsSaysWhyAndGoesOnAfterAFix) {
  Stopped rig;
  ASSERT_EQ(rig.seen.command.linear_m_s, 0.5);
  EXPECT_TRUE(rig.last<msg::RobotDescription>()->knows_limits);
  rig.sample.safety = Safety::protective_stop;
  rig.run(1s);
  EXPECT_EQ(rig.seen.command, Twist{});
  EXPECT_EQ(rig.state().mode, msg::RobotMode::stopped);
  EXPECT_EQ(rig.state().safety, Safety::protective_stop);
  EXPECT_NE(rig.state().reason.find("protective stop"), std::string::npos);
  EXPECT_EQ(rig.last<msg::RouteProgress>()->phase, msg::RoutePhase::stopped);
  EXPECT_TRUE(rig.state().route) << "it keeps its route";
  rig.sample.safety = Safety::ok;
  rig.run(1s);
  EXPECT_EQ(rig.seen.command, Twist{}) << "it has not seen where it is";
  EXPECT_EQ(rig.state().mode, msg::RobotMode::waiting);
  EXPECT_NE(rig.state().reason.find("seen where it is"), std::string::npos);
  rig.see();
  rig.run(1s);
  EXPECT_EQ(rig.seen.command.linear_m_s, 0.5);
  EXPECT_EQ(rig.state().mode, msg::RobotMode::driving);
}

TEST(AgentSafety, AfterAnEmergencyStopAPersonLetsItGoOn) {
  Stopped rig;
  rig.sample.safety = Safety::emergency_stop;
  rig.run(1s);
  rig.tell(rig.command(Kind::stop, 4));
  rig.tell(rig.command(Kind::resume, 5));
  rig.run(1s);
  ASSERT_TRUE(rig.last<msg::AgentReply>());
  EXPECT_FALSE(rig.last<msg::AgentReply>()->done);
  EXPECT_NE(rig.last<msg::AgentReply>()->reason.find("emergency stop"), std::string::npos);
  rig.sample.safety = Safety::ok;
  rig.see();
  rig.run(1s);
  EXPECT_EQ(rig.seen.command, Twist{});
  EXPECT_EQ(rig.state().mode, msg::RobotMode::stopped);
  EXPECT_EQ(rig.state().safety, Safety::emergency_stop);
  rig.tell(rig.command(Kind::resume, 6));
  rig.run(1s);
  EXPECT_EQ(rig.seen.command, Twist{});
  EXPECT_EQ(rig.state().mode, msg::RobotMode::waiting);
  EXPECT_NE(rig.state().reason.find("seen where it is"), std::string::npos);
  rig.see();
  rig.run(1s);
  EXPECT_TRUE(rig.last<msg::AgentReply>()->done);
  EXPECT_EQ(rig.seen.command.linear_m_s, 0.5);
  EXPECT_EQ(rig.state().safety, Safety::ok);
}

TEST(AgentSafety, ARestartedAgentStandsUntilAPersonLetsItGoOn) {
  for (const bool by_operator : {true, false}) {
    Stopped rig;
    if (by_operator) rig.tell(rig.command(Kind::stop, 5));
    rig.sample.safety = by_operator ? Safety::ok : Safety::emergency_stop;
    rig.run(1s);
    rig.restart_agent();
    rig.sample.safety = Safety::ok;
    rig.script->answer.command = {0.5, 0.0};
    rig.see();
    rig.run(1s);
    EXPECT_EQ(rig.seen.command, Twist{});
    EXPECT_EQ(rig.state().mode, msg::RobotMode::stopped);
    EXPECT_EQ(rig.state().safety, by_operator ? Safety::ok : Safety::emergency_stop);
    rig.tell(rig.command(Kind::resume, 6));
    rig.run(1s);
    EXPECT_TRUE(rig.last<msg::AgentReply>()->done);
    rig.restart_agent();
    rig.run(1s);
    EXPECT_NE(rig.state().mode, msg::RobotMode::stopped);
  }
}

}  // namespace
}  // namespace weft::agents::test
