#include "agents/agent/missions/run_recorder.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/bench.hpp"

namespace weft::agents::test {
namespace {

struct RecorderBench : Bench {
  RecorderBench() {
    script->teaches = {"marks", "more"};
    recorder.begin();
  }
  static TaughtRun a_run() {
    TaughtRun run;
    run.experience = ExperienceId{1};
    run.others = {ExperienceId{2}};
    run.name = "aisle";
    return run;
  }
  Kept a_kept_place(ExperienceId experience) const {
    Kept kept;
    kept.content = some_content(experience.value, 50);
    kept.place = a_place(experience, 0, config.self, kept.content);
    return kept;
  }
  RunRecorder recorder{{config.self, *navigator, map, spooler, refining}, a_run()};
};

TEST(RunRecorder, SpoolsAnExperienceForEachMethodUnderItsName) {
  RecorderBench bench;
  EXPECT_EQ(bench.script->taught.front().others, std::vector<ExperienceId>{ExperienceId{2}});
  ASSERT_TRUE(
      bench.recorder.keep({bench.a_kept_place(ExperienceId{1}), bench.a_kept_place(ExperienceId{2})}, bench.now));
  ASSERT_TRUE(bench.recorder.seal(bench.now));
  ASSERT_EQ(bench.disk->records.size(), 2U);
  EXPECT_EQ(bench.disk->records[0].batch.name, "aisle");
  EXPECT_EQ(bench.disk->records[1].batch.name, "aisle-more");
  EXPECT_EQ(bench.recorder.run().kept, 2U);
  EXPECT_EQ(bench.script->forgot_taught, 0);
}

TEST(RunRecorder, ItsContentsAreThereForLocalisingAtOnce) {
  RecorderBench bench;
  const Kept kept = bench.a_kept_place(ExperienceId{1});
  ASSERT_TRUE(bench.recorder.keep({kept}, bench.now));
  ASSERT_NE(bench.map.view().contents.find(kept.place.content.hash), nullptr);
  EXPECT_EQ(*bench.map.view().contents.find(kept.place.content.hash), kept.content);
}

TEST(RunRecorder, SealThatTheSpoolDoesNotTakeForgetsTheRun) {
  RecorderBench bench;
  ASSERT_TRUE(bench.recorder.keep({bench.a_kept_place(ExperienceId{1})}, bench.now));
  bench.disk->faults.full = true;
  EXPECT_FALSE(bench.recorder.seal(bench.now));
  EXPECT_EQ(bench.script->forgot_taught, 1);
  EXPECT_FALSE(bench.script->teaching);
}

TEST(RunRecorder, BreakingOffKeepsWhatWasTaughtAndSaysWhyItEnds) {
  RecorderBench bench;
  ASSERT_TRUE(bench.recorder.keep({bench.a_kept_place(ExperienceId{1})}, bench.now));
  bench.recorder.break_off(bench.now);
  ASSERT_EQ(bench.disk->records.size(), 1U);
  EXPECT_EQ(bench.disk->records.front().batch.places.size(), 1U);
  EXPECT_EQ(bench.disk->records.front().batch.seal_reason, "teaching broke off");
  EXPECT_FALSE(bench.script->teaching);
  EXPECT_EQ(bench.script->forgot_taught, 0);
}

}  // namespace
}  // namespace weft::agents::test
