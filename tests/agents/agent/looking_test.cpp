// When a robot looks for itself of its own accord.
#include <gtest/gtest.h>

#include <string>

#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;
using Kind = msg::AgentCommand::Kind;

Relation metres_ahead(double x) {
  Relation relation;
  std::get<Metric2>(relation).a_from_b.x = x;
  return relation;
}

/// Arranges a robot in a map of one run of ten places.
class Looking : public testing::Test {
 protected:
  void stand(double ahead_m) { rig.script->estimate = Estimate{{laid, 0}, metres_ahead(ahead_m), 0.0}; }
  void be_sent_along(std::uint32_t version, std::uint32_t released) {
    Route route = a_route(laid, 10, 1);
    route.version = version;
    route.released = released;
    rig.tell(rig.order(route));
  }
  /// Says for a while that its route lies elsewhere.
  void stray() {
    rig.script->answer.following = Following::stopped;
    rig.script->answer.reason = "off_route";
    rig.run(3s);
  }
  void find_itself() {
    rig.script->answer.fix = Fix{{laid, 5}, Relation{}, {}};
    rig.run(kOneStep);
    rig.script->answer.fix.reset();
    rig.run(1s);
  }

  static constexpr Duration kOneStep = Rig::kFrame;
  Rig rig;
  ExperienceId laid = rig.lay_out(70, 10);
};

TEST_F(Looking, WhoDoesNotKnowWhereItIsLooksOnceInEachRevision) {
  rig.run(90s);
  ASSERT_EQ(rig.script->sought.size(), 1U);
  rig.run(90s);
  EXPECT_EQ(rig.script->sought.size(), 1U);
  rig.lay_out(71, 5);
  rig.run(15s);
  EXPECT_EQ(rig.script->sought.size(), 2U);
}

TEST_F(Looking, WhoStandsFarOffLooksAgainWhenTheMapChangesAndBelievesOn) {
  stand(2.0);
  rig.run(90s);
  const int before = rig.script->looks;
  EXPECT_EQ(before, 1);
  EXPECT_EQ(rig.script->looks_ended, 1) << "in vain";
  rig.lay_out(71, 5);
  rig.run(15s);
  EXPECT_EQ(rig.script->looks, before + 1);
  EXPECT_TRUE(rig.script->sought.empty()) << "to seek is to forget";
  EXPECT_TRUE(rig.last<msg::RobotState>()->localised);
}

TEST_F(Looking, WhoStandsByAPlaceDoesNot) {
  stand(0.4);
  rig.run(30s);
  rig.lay_out(71, 5);
  rig.run(30s);
  EXPECT_EQ(rig.script->looks, 0);
}

TEST_F(Looking, FoundOffItsRouteItGivesThatBackForAnotherOne) {
  stand(0.0);
  rig.run(4s);
  be_sent_along(1, 5);
  stray();
  EXPECT_EQ(rig.script->looks, 1);
  EXPECT_TRUE(rig.last<msg::RobotState>()->route);
  find_itself();
  EXPECT_FALSE(rig.last<msg::RobotState>()->route);
  be_sent_along(1, 9);
  rig.run(1s);
  EXPECT_FALSE(rig.last<msg::RobotState>()->route) << "more of the same way is no better";
  be_sent_along(2, 9);
  rig.script->answer.following = Following::driving;
  rig.script->answer.reason = "";
  rig.run(1s);
  EXPECT_TRUE(rig.last<msg::RobotState>()->route);
}

TEST_F(Looking, AfterItsStrayRouteWasEndedItLooksNoMore) {
  stand(0.0);
  rig.run(4s);
  be_sent_along(1, 5);
  stray();
  Route ended = a_route(laid, 10, 1);
  ended.ended = true;
  rig.tell(rig.order(ended));
  rig.run(90s);
  const int looks = rig.script->looks;
  rig.run(90s);
  EXPECT_EQ(rig.script->looks, looks);
}

TEST_F(Looking, AGoalWhoseRoutesAllLieElsewhereIsNotAskedForAgainForEver) {
  stand(0.0);
  rig.run(4s);
  constexpr std::uint32_t kMost = 3;
  for (std::uint32_t version = 1; version <= kMost; ++version) {
    be_sent_along(version, 9);
    stray();
    rig.run(15s);
    find_itself();
    EXPECT_FALSE(rig.last<msg::RobotState>()->route) << version;
  }
  be_sent_along(kMost + 1, 9);
  stray();
  rig.run(15s);
  find_itself();
  EXPECT_TRUE(rig.last<msg::RobotState>()->route) << "it fails in the end, and says why";
}

TEST_F(Looking, WhoStandsWithARouteMayBeToldToLocalise) {
  stand(0.0);
  rig.run(4s);
  be_sent_along(1, 9);
  rig.script->answer.following = Following::driving;
  rig.run(1s);
  rig.tell(rig.command(Kind::localise, 3));
  rig.run(1s);
  ASSERT_TRUE(rig.last<msg::AgentReply>());
  EXPECT_NE(rig.last<msg::AgentReply>()->reason.find("drives"), std::string::npos);
  rig.script->answer.following = Following::waiting;
  rig.run(1s);
  rig.tell(rig.command(Kind::localise, 4));
  rig.run(1s);
  EXPECT_EQ(rig.script->sought.size(), 1U);
}

TEST_F(Looking, ALostRobotTurnsOnTheSpotAtMostAndOnlyWithARoute) {
  stand(0.0);
  rig.run(4s);
  rig.script->answer.lost = true;
  rig.script->answer.reason = "lost";
  rig.script->answer.command = {0.3, 0.5};
  rig.run(1s);
  EXPECT_EQ(rig.seen.command, Twist{}) << "nobody waits for it";
  be_sent_along(1, 5);
  rig.run(1s);
  EXPECT_EQ(rig.seen.command, (Twist{0.0, 0.5}));
  rig.tell(rig.command(Kind::stop, 2));
  rig.run(1s);
  EXPECT_EQ(rig.seen.command, Twist{}) << "an operator has stopped it";
}

TEST_F(Looking, OneThatDoesNotKnowWhereItIsTurnsForWhoHasAsked) {
  rig.script->answer.command = {0.0, 0.5};
  rig.run(30s);
  ASSERT_FALSE(rig.script->sought.empty());
  EXPECT_EQ(rig.seen.command, Twist{}) << "it looks of its own accord";
  rig.tell(rig.command(Kind::localise, 2));
  rig.run(2s);
  EXPECT_EQ(rig.seen.command, (Twist{0.0, 0.5}));
}

}  // namespace
}  // namespace weft::agents::test
