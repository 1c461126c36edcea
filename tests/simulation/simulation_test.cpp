#include <gtest/gtest.h>

#include "tests/simulation/run.hpp"
#include "tests/simulation/site.hpp"

namespace weft::simulation {
namespace {

class Simulation : public testing::TestWithParam<std::string> {};

TEST_P(Simulation, TheSameSeedGivesTheSameLife) {
  const RunConfig config{.fleet = {.site = GetParam(), .seed = 1, .robots = 2}, .hours = 0.05};
  const RunResult first = run(config);
  const RunResult second = run(config);
  EXPECT_GT(first.acknowledged, 0U);
  EXPECT_GT(first.refined, 0U) << "every second robot refines what it was taught";
  EXPECT_EQ(first.messages, second.messages);
  EXPECT_EQ(first.trace, second.trace);
  for (const Violation& violation : first.violations) ADD_FAILURE() << violation.invariant << ": " << violation.what;
}

TEST_P(Simulation, AnotherSeedGivesAnotherLife) {
  const RunConfig config{.fleet = {.site = GetParam(), .seed = 1, .robots = 1}, .hours = 0.05};
  RunConfig other = config;
  other.fleet.seed = 2;
  EXPECT_NE(run(config).trace, run(other).trace);
}

INSTANTIATE_TEST_SUITE_P(OnEverySite, Simulation, testing::ValuesIn(site_names()));

}  // namespace
}  // namespace weft::simulation
