#include "agents/agent/missions/localise_mission.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/bench.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;
using Begun = LocaliseMission::Begun;

struct LocaliseBench : Bench {
  LocaliseBench() : laid(lay_out(server, 70, 10)) {}
  SearchPolicy::Situation mistaken() const {
    return {.estimate = Estimate{{laid, 3}, Metric2{Pose2{2.0, 0.0, 0.0}, Eigen::Matrix3d::Zero()}, 0.0}};
  }
  ExperienceId laid;
  LocaliseMission mission{{config.name, *navigator, map, recogniser, replies}, now};
};

TEST(LocaliseMission, SeedWaitsForItsMap) {
  LocaliseBench bench;
  const PlaceId seed{bench.laid, 4};
  bench.mission.start(bench.key(1), seed, bench.now);
  EXPECT_TRUE(bench.mission.has_seed());
  bench.fetch_map(false);
  bench.mission.tick(bench.now);
  EXPECT_TRUE(bench.script->sought.empty());
  bench.fetch_map();
  bench.mission.tick(bench.now);
  EXPECT_EQ(bench.script->sought, std::vector<std::optional<PlaceId>>{seed});
  const SteadyTime since = bench.now;
  EXPECT_EQ(bench.mission.next(), since + 60s);
  EXPECT_FALSE(bench.mission.on_fix({.place = seed, .place_from_robot = {}, .evidence = {}}));
  EXPECT_EQ(bench.only_reply().place, seed);
  EXPECT_FALSE(bench.mission.is_active());
}

TEST(LocaliseMission, FixBeforeItSeeksIsNotItsOwn) {
  LocaliseBench bench;
  bench.mission.start(bench.key(1), std::nullopt, bench.now);
  EXPECT_FALSE(bench.mission.on_fix({}));
  EXPECT_TRUE(bench.mission.is_active());
  EXPECT_TRUE(bench.replied().empty());
}

TEST(LocaliseMission, MapThatDoesNotComeIsRefusedAfterTwentySeconds) {
  LocaliseBench bench;
  bench.mission.start(bench.key(1), std::nullopt, bench.now);
  bench.mission.was_away(2s);
  bench.mission.tick(bench.now + 21s);
  EXPECT_TRUE(bench.mission.is_active());
  bench.mission.tick(bench.now + 22s);
  EXPECT_EQ(bench.only_reply().reason.rfind("any part of the network did not arrive", 0), 0U);
}

TEST(LocaliseMission, LaterCommandRefusesTheEarlierOne) {
  LocaliseBench bench;
  bench.mission.start(bench.key(1), std::nullopt, bench.now);
  bench.mission.start(bench.key(2), std::nullopt, bench.now);
  const msg::AgentReply reply = bench.only_reply();
  EXPECT_EQ(reply.command, 1U);
  EXPECT_EQ(reply.reason, "another search was asked for meanwhile");
}

TEST(LocaliseMission, SearchInVainOfItsOwnAccordIsNotAnswered) {
  LocaliseBench bench;
  bench.fetch_map();
  EXPECT_EQ(bench.mission.search_if_due({}, bench.now), Begun::anew);
  EXPECT_EQ(bench.mission.search_if_due({}, bench.now), Begun::nothing) << "one at a time";
  bench.mission.tick(bench.now);
  EXPECT_EQ(bench.script->sought.size(), 1U);
  bench.mission.tick(bench.now + 60s);
  EXPECT_FALSE(bench.mission.is_active());
  EXPECT_TRUE(bench.replied().empty());
  EXPECT_EQ(bench.script->looks_ended, 0);
}

TEST(LocaliseMission, RobotThatMayBeMistakenKeepsItsBeliefAndSaysSoWhenItIsFound) {
  LocaliseBench bench;
  bench.fetch_map();
  EXPECT_EQ(bench.mission.search_if_due(bench.mistaken(), bench.now), Begun::again);
  bench.mission.tick(bench.now);
  EXPECT_EQ(bench.script->looks, 1);
  EXPECT_TRUE(bench.script->sought.empty());
  EXPECT_TRUE(bench.mission.on_fix({})) << "its route may lie elsewhere";
}

TEST(LocaliseMission, LookInVainOfARobotThatBelievesEndsTheNavigatorsLook) {
  LocaliseBench bench;
  bench.fetch_map();
  ASSERT_EQ(bench.mission.search_if_due(bench.mistaken(), bench.now), Begun::again);
  bench.mission.tick(bench.now);
  bench.mission.tick(bench.now + 60s);
  EXPECT_EQ(bench.script->looks_ended, 1);
  EXPECT_TRUE(bench.script->sought.empty());
}

TEST(LocaliseMission, DescribesItselfWithTheProposedPlaces) {
  LocaliseBench bench;
  EXPECT_EQ(bench.mission.describe(), "");
  bench.mission.start(bench.key(1), std::nullopt, bench.now);
  EXPECT_EQ(bench.mission.describe(), "looks for itself");
  bench.map.look_at({{bench.laid, 1}, {bench.laid, 2}}, bench.context(), bench.now);
  EXPECT_EQ(bench.mission.describe().rfind("looks for itself among 2 places", 0), 0U);
}

}  // namespace
}  // namespace weft::agents::test
