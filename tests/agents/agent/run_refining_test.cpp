#include "agents/agent/run_refining.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/bench.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

constexpr ExperienceId kRefinedRun{1};

struct RefiningBench : Bench {
  RefiningBench() { script->refines = {"marks"}; }

  void begin(ExperienceId run, const std::string& method = "marks") {
    spooler.begin(run, "");
    refining.begin(run, method);
  }
  void keep(ExperienceId run, std::uint32_t index) {
    Kept kept;
    kept.content = some_content(run.value * 100 + index, 50);
    kept.place = a_place(run, index, config.self, kept.content);
    if (index > 0) kept.edges.push_back(an_edge({run, index - 1}, kept.place.id));
    ASSERT_TRUE(spooler.add(kept, now));
    refining.add(kept);
  }
  void end(ExperienceId run) {
    ASSERT_TRUE(spooler.seal("taught to its end", now));
    refining.end(run);
  }
  /// Teaches seven places: two batches.
  void teach(ExperienceId run) {
    begin(run);
    for (std::uint32_t i = 0; i < 7; ++i) keep(run, i);
    end(run);
  }
  /// Lets so many samples of 100 ms come.
  void sample(int times) {
    for (; times > 0; --times) refining.work(false, now += 100ms);
  }
  std::vector<Batch> due() { return *spooler.due(now + 1h); }
};

TEST(RunRefining, NothingIsSentBeforeTheLastPiece) {
  RefiningBench bench;
  bench.teach(kRefinedRun);
  EXPECT_FALSE(bench.spooler.next()) << "nothing is to be sent at any time";
  EXPECT_TRUE(bench.due().empty());
  while (!bench.refining.describe().empty()) {
    EXPECT_TRUE(bench.due().empty()) << bench.refining.describe();
    bench.sample(1);
  }
  const std::vector<Batch> batches = bench.due();
  ASSERT_EQ(batches.size(), 2U);
  EXPECT_EQ(batches.back().seal_reason, "taught to its end");
  for (const Batch& batch : batches)
    for (const Edge& edge : batch.edges)
      EXPECT_TRUE(identical(edge.a_from_b, refined(an_edge(edge.id.a, edge.id.b).a_from_b)));
}

TEST(RunRefining, WhatIsSentIsWhatTheSpoolHas) {
  RefiningBench bench;
  bench.teach(kRefinedRun);
  bench.sample(20);
  const std::vector<Batch> batches = bench.due();
  ASSERT_EQ(batches.size(), bench.disk->records.size());
  for (std::size_t i = 0; i < batches.size(); ++i) {
    EXPECT_EQ(hash(batches[i]), hash(bench.disk->records[i].batch));
    for (const Place& place : batches[i].places) EXPECT_TRUE(bench.spool->content(place.content.hash));
  }
}

TEST(RunRefining, AmendedContentsAreThereForLocalisingAtOnce) {
  RefiningBench bench;
  bench.teach(kRefinedRun);
  bench.sample(20);
  const Place& place = bench.disk->records.front().batch.places.front();
  ASSERT_NE(bench.map.view().contents.find(place.content.hash), nullptr);
}

/// Returns how many pieces are done in ten seconds of 30 samples each; -1: it does not say.
int pieces_in_ten_seconds(bool is_driving) {
  RefiningBench bench;
  bench.script->pieces = 1000;
  bench.teach(kRefinedRun);
  for (int i = 0; i < 300; ++i) bench.refining.work(is_driving, bench.now += 33ms);
  const std::string text = bench.refining.describe();
  const std::string before = "refines what it was taught: ";
  return text.starts_with(before) ? std::stoi(text.substr(before.size())) : -1;
}

TEST(RunRefining, TakesHalfOfTheTimeAtMost) {
  const int done = pieces_in_ten_seconds(false);
  EXPECT_GE(done, 95) << "of 50 ms each";
  EXPECT_LE(done, 105);
}

TEST(RunRefining, TakesATenthOfTheTimeWhileItDrives) {
  const int done = pieces_in_ten_seconds(true);
  EXPECT_GE(done, 19) << "of 50 ms each";
  EXPECT_LE(done, 22);
}

TEST(RunRefining, SaysHowFarItIsAndWhatWaits) {
  RefiningBench bench;
  EXPECT_EQ(bench.refining.describe(), "");
  bench.teach(kRefinedRun);
  EXPECT_EQ(bench.refining.describe(), "refines what it was taught: begins");
  bench.teach(ExperienceId{2});
  bench.sample(3);
  EXPECT_EQ(bench.refining.describe(), "refines what it was taught: 2 of 5 pieces; 1 more run waits");
  bench.sample(20);
  EXPECT_EQ(bench.refining.describe(), "");
}

TEST(RunRefining, IsInterruptedByAnyRunThatIsTaughtAndResumed) {
  RefiningBench bench;
  bench.teach(kRefinedRun);
  bench.sample(2);
  const std::string before = bench.refining.describe();
  bench.begin(ExperienceId{2}, "another");
  EXPECT_EQ(bench.refining.describe(), "");
  EXPECT_FALSE(bench.refining.next());
  bench.sample(20);
  bench.keep(ExperienceId{2}, 0);
  bench.end(ExperienceId{2});
  EXPECT_EQ(bench.refining.describe(), before) << "it goes on where it was";
  EXPECT_EQ(bench.due().size(), 1U) << "what is not refined does not wait";
  bench.sample(20);
  EXPECT_EQ(bench.due().size(), 3U);
}

TEST(RunRefining, GoesOnWithoutSamples) {
  RefiningBench bench;
  bench.teach(kRefinedRun);
  for (int i = 0; i < 10 && bench.refining.next(); ++i) {
    bench.now = *bench.refining.next();
    bench.refining.tick(bench.now);
  }
  EXPECT_FALSE(bench.refining.next());
  EXPECT_EQ(bench.due().size(), 2U);
}

TEST(RunRefining, TickBetweenSamplesLeavesTheirTimeAlone) {
  RefiningBench bench;
  bench.teach(kRefinedRun);
  bench.sample(1);
  const std::string before = bench.refining.describe();
  bench.refining.tick(bench.now + 99ms);
  EXPECT_EQ(bench.refining.describe(), before);
}

TEST(RunRefining, RunWithoutPlacesLeavesNothingToRefine) {
  RefiningBench bench;
  bench.begin(kRefinedRun);
  bench.end(kRefinedRun);
  EXPECT_FALSE(bench.spooler.is_held(kRefinedRun));
  EXPECT_EQ(bench.refining.describe(), "");
}

TEST(RunRefining, FullDiskHandsInTheDraftAndSaysSo) {
  RefiningBench bench;
  bench.teach(kRefinedRun);
  bench.disk->faults.full = true;
  bench.sample(20);
  const std::vector<Batch> batches = bench.due();
  ASSERT_EQ(batches.size(), 2U);
  EXPECT_EQ(batches.back().seal_reason, "taught to its end, handed in before it was refined");
  EXPECT_EQ(hash(batches.front()), hash(bench.disk->records.front().batch));
  const AgentOutput output = bench.take();
  ASSERT_EQ(output.notes.size(), 1U);
  EXPECT_NE(output.notes.front().find("is handed in as the spool has it"), std::string::npos);
}

TEST(RunRefining, AmendmentsThatDoNotFitHandInTheDraft) {
  RefiningBench bench;
  bench.script->spoilt.edges.push_back({{{kRefinedRun, 0}, {kRefinedRun, 5}}, Metric2{}});
  bench.teach(kRefinedRun);
  bench.sample(20);
  const std::vector<Batch> batches = bench.due();
  ASSERT_EQ(batches.size(), 2U);
  EXPECT_EQ(batches.back().seal_reason, "taught to its end, handed in before it was refined");
}

TEST(RunRefining, FullDiskWhileTaughtHandsInWhatIsThere) {
  RefiningBench bench;
  bench.begin(kRefinedRun);
  for (std::uint32_t i = 0; i < 5; ++i) bench.keep(kRefinedRun, i);
  bench.disk->faults.full = true;
  bench.keep(kRefinedRun, 5);
  EXPECT_FALSE(bench.spooler.seal("taught to its end", bench.now));
  bench.refining.end(kRefinedRun);
  EXPECT_EQ(bench.refining.describe(), "");
  EXPECT_EQ(bench.due().size(), 1U);
}

}  // namespace
}  // namespace weft::agents::test
