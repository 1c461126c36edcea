#include "agents/agent/standing.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using Mode = msg::RobotMode;

struct StandingBench {
  Standing standing() const {
    return {.condition = condition,
            .task = task,
            .incompatible = incompatible,
            .taught = taught,
            .teaching_failure = failure,
            .searches = searches,
            .route_waits_for = waits_for,
            .notice = notice};
  }
  Mode mode() const { return mode_of(standing()); }
  std::string reason() const { return reason_of(standing()); }
  void take_route(const std::string& reason) {
    Route route = a_route(ExperienceId{70}, 3, 1);
    route.reason = reason;
    task.take(route, SteadyTime{});
  }

  Condition condition;
  RouteTask task;
  std::string incompatible;
  std::optional<std::string> taught;
  std::string failure;
  std::string searches;
  std::string waits_for;
  std::string notice = "camera sits low";
};

TEST(Standing, ModesYieldToEachOtherInThisOrder) {
  StandingBench bench;
  EXPECT_EQ(bench.mode(), Mode::idle);
  bench.take_route("");
  EXPECT_EQ(bench.mode(), Mode::waiting);
  bench.task.set(msg::RoutePhase::driving, {}, SteadyTime{});
  EXPECT_EQ(bench.mode(), Mode::driving);
  bench.condition.lost = true;
  EXPECT_EQ(bench.mode(), Mode::lost);
  bench.condition.stopped = true;
  EXPECT_EQ(bench.mode(), Mode::stopped);
  bench.taught = "";
  EXPECT_EQ(bench.mode(), Mode::teaching);
  bench.condition.fault = "no base";
  EXPECT_EQ(bench.mode(), Mode::faulted);
  EXPECT_EQ(bench.reason(), "no base");
  bench.incompatible = "speaks version 9";
  EXPECT_EQ(bench.reason(), "speaks version 9") << "nothing else is of use then";
}

TEST(Standing, ArrivedRobotIsIdle) {
  StandingBench bench;
  bench.take_route("");
  bench.task.set(msg::RoutePhase::arrived, {}, SteadyTime{});
  EXPECT_EQ(bench.mode(), Mode::idle);
}

TEST(Standing, IdleSaysWhyTeachingEndedThenHowItLooksThenWhatIsNoticed) {
  StandingBench bench;
  EXPECT_EQ(bench.reason(), "camera sits low");
  bench.searches = "looks for itself";
  EXPECT_EQ(bench.reason(), "looks for itself");
  bench.failure = "teaching ended: disk full";
  EXPECT_EQ(bench.reason(), "teaching ended: disk full");
}

TEST(Standing, WaitingSaysWhatItWaitsForThenTheServersReasonThenTheNavigators) {
  StandingBench bench;
  bench.take_route("");
  bench.condition.stands_for = "end of what is released";
  EXPECT_EQ(bench.reason(), "end of what is released");
  StandingBench told;
  told.condition = bench.condition;
  told.take_route("waits for r2");
  EXPECT_EQ(told.reason(), "waits for r2");
  told.waits_for = "waits for the map of its route";
  EXPECT_EQ(told.reason(), "waits for the map of its route");
}

TEST(Standing, RobotBeforeSomethingThatItsMethodSeesSaysSo) {
  StandingBench bench;
  bench.take_route("waits for r2");
  bench.condition.stands_for = kSomethingAhead;
  EXPECT_TRUE(bench.condition.sees_something());
  EXPECT_EQ(bench.reason(), "something stands in its way: after a while it goes another way, if there is one");
  bench.condition.stopped = true;
  EXPECT_FALSE(bench.condition.sees_something()) << "an operator has it stand";
}

TEST(Standing, TaughtRobotThatIsStoppedSaysSo) {
  StandingBench bench;
  bench.taught = "hand_done";
  EXPECT_EQ(bench.reason(), "hand_done");
  bench.condition.stopped = true;
  EXPECT_EQ(bench.reason(), "stopped by an operator");
}

TEST(Condition, CommandIsInForceOnlyForARobotThatMayMove) {
  Condition condition;
  condition.command = {0.5, 0.1};
  EXPECT_EQ(condition.allowed_command().linear_m_s, 0.5);
  for (void (*hold)(Condition&) : {+[](Condition& c) { c.lost = true; }, +[](Condition& c) { c.stopped = true; },
                                   +[](Condition& c) { c.fault = "no base"; }}) {
    Condition held = condition;
    hold(held);
    EXPECT_EQ(held.allowed_command().linear_m_s, 0.0);
    EXPECT_EQ(held.allowed_command().angular_rad_s, 0.0);
  }
}

TEST(Condition, ALostRobotThatMayLookAroundTurnsAndDoesNotDrive) {
  Condition condition;
  condition.command = {0.5, 0.1};
  condition.lost = true;
  condition.may_look_around = true;
  EXPECT_EQ(condition.allowed_command(), (Twist{0.0, 0.1}));
  condition.stopped = true;
  EXPECT_EQ(condition.allowed_command(), Twist{});
}

}  // namespace
}  // namespace weft::agents::test
