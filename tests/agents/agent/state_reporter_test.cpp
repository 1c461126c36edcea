#include "agents/agent/state_reporter.hpp"

#include <gtest/gtest.h>

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

struct ReporterBench {
  /// Returns whether the state goes out after that much time.
  bool due(Duration at) { return reporter.state_due(state, start + at); }
  SteadyTime start = SteadyTime{} + 1h;
  StateReporter reporter{start};
  msg::RobotState state;
};

TEST(StateReporter, IdleRobotSaysTheSameEveryThreeSecondsAndAMovingOneTwiceASecond) {
  ReporterBench bench;
  EXPECT_TRUE(bench.due(0s));
  EXPECT_FALSE(bench.due(2900ms));
  bench.state.speed_m_s = 0.5;
  EXPECT_TRUE(bench.due(3s));
  EXPECT_FALSE(bench.due(3400ms)) << "speed alone is no change that matters";
  EXPECT_TRUE(bench.due(3500ms));
}

TEST(StateReporter, ChangesThatMatterWaitForATenthOfASecond) {
  using Change = void (*)(msg::RobotState&);
  const Change changes[] = {[](msg::RobotState& state) { state.mode = msg::RobotMode::lost; },
                            [](msg::RobotState& state) { state.localised = true; },
                            [](msg::RobotState& state) { state.route.bytes[0] = 1; },
                            [](msg::RobotState& state) { state.route_version = 2; },
                            [](msg::RobotState& state) { state.experience.value = 3; },
                            [](msg::RobotState& state) { state.window_digest.bytes[0] = 4; },
                            [](msg::RobotState& state) { state.contents_missing = 5; },
                            [](msg::RobotState& state) { state.reason = "blocked"; }};
  for (const Change change : changes) {
    ReporterBench bench;
    ASSERT_TRUE(bench.due(0s));
    change(bench.state);
    EXPECT_FALSE(bench.due(50ms));
    EXPECT_EQ(bench.reporter.next(), bench.start);  // the description is still due
    EXPECT_TRUE(bench.due(100ms));
    EXPECT_FALSE(bench.due(200ms)) << "it has been said";
  }
}

TEST(StateReporter, AnotherNumberOfMissingContentsIsNoChange) {
  ReporterBench bench;
  bench.state.contents_missing = 9;
  ASSERT_TRUE(bench.due(0s));
  bench.state.contents_missing = 8;
  EXPECT_FALSE(bench.due(1s));
}

TEST(StateReporter, DescribesItselfEveryTenSecondsAndToANewServer) {
  ReporterBench bench;
  EXPECT_TRUE(bench.reporter.description_due(bench.start));
  EXPECT_FALSE(bench.reporter.description_due(bench.start + 9s));
  EXPECT_TRUE(bench.reporter.description_due(bench.start + 10s));
  ASSERT_TRUE(bench.due(10s));
  bench.reporter.server_restarted(bench.start + 11s);
  EXPECT_EQ(bench.reporter.next(), bench.start + 11s);
  EXPECT_TRUE(bench.reporter.description_due(bench.start + 11s));
  EXPECT_TRUE(bench.due(11s));
}

}  // namespace
}  // namespace weft::agents::test
