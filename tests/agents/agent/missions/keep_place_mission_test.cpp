#include "agents/agent/missions/keep_place_mission.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/bench.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

struct KeepBench : Bench {
  KeepBench() : laid(lay_out(server, 70, 10)) {
    fetch_map();
    script->estimate = Estimate{{laid, 3}, Metric2{Pose2{0.3, 0.0, 0.0}, Eigen::Matrix3d::Zero()}, 0.0};
  }
  ExperienceId laid;
  KeepPlaceMission mission{{config, *navigator, map, spooler, ids, replies}};
};

TEST(KeepPlaceMission, ViewsBeforeTheCommandAreNotLookedAt) {
  KeepBench bench;
  bench.script->joins = std::vector<Edge>{an_edge({bench.laid, 3}, {})};
  bench.mission.on_view(bench.now);
  EXPECT_TRUE(bench.script->taught.empty());
}

TEST(KeepPlaceMission, PlaceIsOnTheDiskAndInTheCacheWhenItIsAnswered) {
  KeepBench bench;
  bench.script->joins = std::vector<Edge>{an_edge({bench.laid, 3}, {})};
  bench.mission.start({}, bench.key(1), false, bench.now);
  EXPECT_TRUE(bench.replied().empty());
  bench.mission.on_view(bench.now);
  const msg::AgentReply reply = bench.only_reply();
  EXPECT_TRUE(reply.done);
  EXPECT_TRUE(bench.spooler.is_pending(reply.experience));
  ASSERT_EQ(bench.disk->records.size(), 1U);
  EXPECT_FALSE(bench.mission.is_active());
}

TEST(KeepPlaceMission, LostRobotRefusesAlthoughItHasAnEstimate) {
  KeepBench bench;
  bench.mission.start({}, bench.key(1), true, bench.now);
  EXPECT_NE(bench.only_reply().reason.find("does not know where it is"), std::string::npos);
}

TEST(KeepPlaceMission, GivesUpWithTheReasonOfTheLastView) {
  KeepBench bench;
  bench.mission.start({}, bench.key(1), false, bench.now);
  bench.mission.was_away(1s);
  EXPECT_EQ(bench.mission.next(), bench.now + 16s);
  bench.mission.on_view(bench.now);
  bench.mission.tick(bench.now + 15s);
  EXPECT_TRUE(bench.mission.is_active());
  bench.mission.tick(bench.now + 16s);
  const std::string reason = bench.only_reply().reason;
  EXPECT_NE(reason.find("(few_inliers)"), std::string::npos) << reason;
  EXPECT_NE(reason.find("0.30 m and 0.0 degrees from place"), std::string::npos) << reason;
}

TEST(KeepPlaceMission, WithoutAViewItSaysThatNoImageCame) {
  KeepBench bench;
  bench.mission.start({}, bench.key(1), false, bench.now);
  bench.mission.tick(bench.now + 15s);
  EXPECT_NE(bench.only_reply().reason.find("(no image came)"), std::string::npos);
}

TEST(KeepPlaceMission, LaterCommandRefusesTheEarlierOne) {
  KeepBench bench;
  bench.mission.start({}, bench.key(1), false, bench.now);
  bench.mission.start({}, bench.key(2), false, bench.now);
  EXPECT_EQ(bench.only_reply().command, 1U);
  EXPECT_TRUE(bench.mission.is_active());
}

TEST(KeepPlaceMission, FullDiskIsSaidAndTheWishIsOver) {
  KeepBench bench;
  bench.script->joins = std::vector<Edge>{an_edge({bench.laid, 3}, {})};
  bench.disk->faults.full = true;
  bench.mission.start({}, bench.key(1), false, bench.now);
  bench.mission.on_view(bench.now);
  EXPECT_FALSE(bench.only_reply().done);
  EXPECT_FALSE(bench.mission.is_active());
}

}  // namespace
}  // namespace weft::agents::test
