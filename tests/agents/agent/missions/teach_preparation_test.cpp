#include "agents/agent/missions/teach_preparation.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/bench.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;
using Step = TeachPreparation::Step;

struct PreparationBench : Bench {
  TeachPreparation::Uses uses() { return {config.name, *navigator, map, outbox}; }
};
const std::vector<SitePoint> kLine{{0.0, 0.0}, {1.0, 0.0}};

TEST(TeachPreparation, NeedsNothingWithoutSeedAndLine) {
  PreparationBench bench;
  TeachPreparation preparation(std::nullopt, {}, bench.now);
  EXPECT_FALSE(preparation.next().has_value());
  const Result<Step> step = preparation.tick(bench.uses(), bench.now);
  ASSERT_TRUE(step);
  EXPECT_EQ(*step, Step::begins);
}

TEST(TeachPreparation, LineWaitsForTheHandWithoutADeadline) {
  PreparationBench bench;
  TeachPreparation preparation(std::nullopt, kLine, bench.now);
  EXPECT_EQ(*preparation.tick(bench.uses(), bench.now), Step::waits);
  EXPECT_EQ(bench.take().hand_start, kLine);
  EXPECT_TRUE(preparation.awaits_hand());
  EXPECT_FALSE(preparation.next().has_value());
  EXPECT_EQ(*preparation.tick(bench.uses(), bench.now + 1h), Step::waits);
  EXPECT_FALSE(bench.take().hand_start.has_value()) << "it is asked once";
}

TEST(TeachPreparation, SeedLooksThereOnceItsMapIsThere) {
  PreparationBench bench;
  const PlaceId seed{lay_out(bench.server, 70, 10), 4};
  TeachPreparation preparation(seed, kLine, bench.now);
  bench.fetch_map(false);
  EXPECT_EQ(*preparation.tick(bench.uses(), bench.now), Step::waits);
  EXPECT_TRUE(bench.script->sought.empty()) << "without contents there is nothing to look at";
  bench.fetch_map();
  EXPECT_EQ(*preparation.tick(bench.uses(), bench.now), Step::waits);
  ASSERT_EQ(bench.script->sought.size(), 1U);
  EXPECT_EQ(bench.script->sought.front(), seed);
  EXPECT_TRUE(preparation.seeks());
  EXPECT_EQ(preparation.on_fix(bench.uses()), Step::waits);
  EXPECT_TRUE(preparation.awaits_hand());
}

TEST(TeachPreparation, SearchInVainEndsAfterAMinuteAndForgetsTheSeed) {
  PreparationBench bench;
  const PlaceId seed{lay_out(bench.server, 70, 10), 4};
  TeachPreparation preparation(seed, {}, bench.now);
  bench.fetch_map();
  ASSERT_TRUE(preparation.tick(bench.uses(), bench.now));
  ASSERT_TRUE(preparation.tick(bench.uses(), bench.now + 59s));
  const Result<Step> step = preparation.tick(bench.uses(), bench.now + 60s);
  ASSERT_FALSE(step);
  EXPECT_NE(step.error().message.find("did not find itself around"), std::string::npos);
  EXPECT_EQ(bench.script->sought.back(), std::nullopt);
}

TEST(TeachPreparation, MapThatDoesNotComeEndsAfterTwentySecondsOfBeingThere) {
  PreparationBench bench;
  TeachPreparation preparation(PlaceId{ExperienceId{70}, 4}, {}, bench.now);
  preparation.was_away(5s);
  EXPECT_EQ(preparation.next(), bench.now + 25s);
  ASSERT_TRUE(preparation.tick(bench.uses(), bench.now + 24s));
  const Result<Step> step = preparation.tick(bench.uses(), bench.now + 25s);
  ASSERT_FALSE(step);
  EXPECT_NE(step.error().message.find("did not arrive in 20 s"), std::string::npos);
}

}  // namespace
}  // namespace weft::agents::test
