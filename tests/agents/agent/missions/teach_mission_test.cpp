#include "agents/agent/missions/teach_mission.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/bench.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

struct TeachBench : Bench {
  /// Arranges the mission with a run that is on.
  void begin(const std::string& name = "aisle") {
    msg::AgentCommand command;
    command.name = name;
    EXPECT_TRUE(mission.start(command, key(1), {}, false, now));
    mission.tick(now);
    EXPECT_TRUE(only_reply().done);
  }
  std::vector<Kept> one_place() const {
    Kept kept;
    kept.content = some_content(1, 50);
    kept.place = a_place(script->taught.back().experience, 0, config.self, kept.content);
    return {kept};
  }
  TeachMission mission{{config, *navigator, map, spooler, ids, replies, outbox}, now};
};

TEST(TeachMission, WithoutSeedAndLineBeginsAtTheFirstTick) {
  TeachBench bench;
  EXPECT_TRUE(bench.mission.start({}, bench.key(1), {}, false, bench.now));
  EXPECT_TRUE(bench.script->taught.empty());
  EXPECT_TRUE(bench.replied().empty());
  bench.mission.tick(bench.now);
  ASSERT_EQ(bench.script->taught.size(), 1U);
  EXPECT_EQ(bench.only_reply().experience, bench.script->taught.front().experience);
  EXPECT_EQ(bench.mission.experience(), bench.script->taught.front().experience);
}

TEST(TeachMission, IsRefusedByWhatTheRobotIsUpToAndLeavesNothingBehind) {
  Condition faulted;
  faulted.fault = "no base";
  Condition stopped;
  stopped.stopped = true;
  struct Row {
    Condition condition;
    bool has_route = false;
    const char* reason = nullptr;
  };
  for (const Row& row : {Row{faulted, true, "out of order: no base"}, Row{stopped, true, "has a goal"},
                         Row{stopped, false, "is stopped"}}) {
    TeachBench bench;
    EXPECT_FALSE(bench.mission.start({}, bench.key(1), row.condition, row.has_route, bench.now));
    EXPECT_NE(bench.only_reply().reason.find(row.reason), std::string::npos) << row.reason;
    EXPECT_FALSE(bench.mission.is_active());
    EXPECT_FALSE(bench.mission.next().has_value());
  }
}

TEST(TeachMission, HasNoDeadlineWhileItIsOnAndOneWhileItEnds) {
  TeachBench bench;
  bench.begin();
  EXPECT_FALSE(bench.mission.next().has_value());
  bench.mission.stop(bench.key(2), bench.now);
  EXPECT_EQ(bench.mission.next(), bench.now + 3s);
  bench.mission.was_away(5s);
  EXPECT_EQ(bench.mission.next(), bench.now + 8s) << "no wait counts the time that the process was away";
}

TEST(TeachMission, EndsWithoutTheLastViewAfterItsDeadline) {
  TeachBench bench;
  bench.begin();
  bench.mission.stop(bench.key(2), bench.now);
  bench.mission.tick(bench.now + 2s);
  EXPECT_TRUE(bench.mission.is_active());
  bench.mission.tick(bench.now + 3s);
  EXPECT_FALSE(bench.mission.is_active());
  bench.mission.confirm(bench.now + 3s);
  EXPECT_TRUE(bench.only_reply().done);
}

TEST(TeachMission, EndRefusesThePlaceThatWasStillWanted) {
  TeachBench bench;
  bench.begin();
  bench.mission.keep_place(bench.key(2), bench.now);
  bench.mission.stop(bench.key(3), bench.now);
  bench.mission.tick(bench.now + 3s);
  EXPECT_EQ(bench.only_reply().reason, "teaching ended before a place was kept");
}

TEST(TeachMission, SpoolThatTakesNothingEndsItAndSaysWhy) {
  TeachBench bench;
  bench.begin();
  bench.mission.keep_place(bench.key(2), bench.now);
  bench.disk->faults.full = true;
  bench.mission.step(bench.one_place(), false, bench.now);
  EXPECT_FALSE(bench.mission.is_active());
  EXPECT_EQ(bench.mission.failure().rfind("teaching ended: ", 0), 0U) << bench.mission.failure();
  EXPECT_EQ(bench.only_reply().reason, bench.mission.failure());
  EXPECT_GE(bench.script->forgot_taught, 1);
  bench.mission.forget_failure();
  EXPECT_EQ(bench.mission.failure(), "");
}

TEST(TeachMission, RefusedBatchOfAnOlderRunIsForgottenAndTeachingGoesOn) {
  TeachBench bench;
  bench.begin();
  Spooler::Heard heard;
  heard.reason = "the server refused batch 2: its clock is wrong";
  bench.mission.refused(ExperienceId{77}, heard, bench.now);
  EXPECT_TRUE(bench.mission.is_active());
  EXPECT_EQ(bench.script->forgot_taught, 1);
}

TEST(TeachMission, AnswerToTheNextPartIsHandedBackWithTheLastPartForgotten) {
  TeachBench bench;
  bench.begin();
  bench.mission.step({}, true, bench.now);
  EXPECT_EQ(bench.mission.waits_for(), "hand_done");
  msg::AgentCommand on;
  on.name = "aisle";
  on.along = {{0.0, 0.0}, {2.0, 0.0}};
  EXPECT_FALSE(bench.mission.start(on, bench.key(2), {}, false, bench.now));
  EXPECT_TRUE(bench.take().hand_start.has_value());
  const std::optional<TeachMission::Answer> answer = bench.mission.hand_answered({});
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(answer->key, bench.key(2));
  EXPECT_TRUE(answer->reply.done);
  EXPECT_EQ(bench.mission.waits_for(), "") << "whoever waits would see the end of the last part";
  EXPECT_TRUE(bench.replied().empty()) << "the state goes first";
}

TEST(TeachMission, BodyThatFailsBeforeItBeginsRefusesTheStart) {
  TeachBench bench;
  msg::AgentCommand command;
  command.seed = PlaceId{ExperienceId{70}, 1};
  ASSERT_TRUE(bench.mission.start(command, bench.key(1), {}, false, bench.now));
  EXPECT_EQ(bench.mission.waits_for(), "waits for the map around its seed");
  bench.mission.break_off("the body failed: no base", bench.now);
  EXPECT_EQ(bench.only_reply().reason, "the body failed: no base");
  EXPECT_FALSE(bench.mission.is_active());
}

}  // namespace
}  // namespace weft::agents::test
