#include <gtest/gtest.h>

#include "tests/simulation/run.hpp"

namespace weft::simulation {
namespace {

TEST(Simulation, TheSameSeedGivesTheSameLife) {
  const RunConfig config{.seed = 1, .robots = 2, .hours = 0.05};
  const RunResult first = run(config);
  const RunResult second = run(config);
  EXPECT_GT(first.acknowledged, 0U);
  EXPECT_EQ(first.messages, second.messages);
  EXPECT_EQ(first.trace, second.trace);
  for (const Violation& violation : first.violations) ADD_FAILURE() << violation.invariant << ": " << violation.what;
}

TEST(Simulation, AnotherSeedGivesAnotherLife) {
  const RunConfig config{.seed = 1, .robots = 1, .hours = 0.05};
  RunConfig other = config;
  other.seed = 2;
  EXPECT_NE(run(config).trace, run(other).trace);
}

}  // namespace
}  // namespace weft::simulation
