#include "core/network/codec.hpp"
#include "tests/contract/map_store/store_fixture.hpp"
#include "tests/storage/sample_map.hpp"
#include "tests/storage/temporary_directory.hpp"

/// Tests upkeep while the store is used: what is asked of every engine.
namespace weft::storage {
namespace {

using MapUpkeep = StoreTest;

TEST_P(MapUpkeep, APreparationIsKeptByItsMethodsAndMakesNoRevision) {
  Random random(5);
  const Bytes first = sample::content(random, 3000);
  const Bytes second = sample::content(random, 9'000'000);
  EXPECT_EQ(store_->preparation("floor").error().code, ErrorCode::not_found);
  EXPECT_EQ(commit({{PutPreparation{"floor", first}, PutPreparation{"floor,marks", {}}}}), Revision{0});
  EXPECT_EQ(commit({{PutPreparation{"floor", second}}}), Revision{0});
  restart();
  EXPECT_EQ(store_->preparation("floor").value(), second);
  EXPECT_EQ(store_->preparation("floor,marks").value(), Bytes{});
  EXPECT_EQ(store_->preparation("marks").error().code, ErrorCode::not_found);
  EXPECT_EQ(refusal({{PutPreparation{"", first}}}), ErrorCode::invalid);
}

TEST_P(MapUpkeep, PassesAreKeptByTheirPieceAndMakeNoRevision) {
  sample::Run run(0x11, 1);
  commit(sample::transaction(run.next(40)));
  const RunPiece onward{run.experience(), 1, true};
  const RunPiece back{run.experience(), 1, false};
  const std::vector<Pass> two = {{8.0, 16.0, 0.0}, {8.0, 20.5, 3.25}};
  EXPECT_EQ(commit({{PutPasses{onward, {two[0]}}, PutPasses{back, {two[1]}}}}), Revision{1});
  EXPECT_EQ(commit({{PutPasses{onward, two}}}), Revision{1});
  restart();
  EXPECT_EQ(stored_.passes, (std::map<RunPiece, std::vector<Pass>>{{onward, two}, {back, {two[1]}}}));
  EXPECT_TRUE(finish(store_->check()).findings.empty());
  EXPECT_EQ(refusal({{PutPasses{onward, {}}}}), ErrorCode::invalid);
  EXPECT_EQ(refusal({{PutPasses{onward, std::vector<Pass>(kPassesKept + 1)}}}), ErrorCode::invalid);
}

TEST_P(MapUpkeep, PassesGoWithTheLastPlaceOfTheirPiece) {
  sample::Run run(0x11, 1);
  commit(sample::transaction(run.next(40)));  // 1
  const RunPiece first{run.experience(), 0, true};
  const RunPiece second{run.experience(), 1, true};
  const std::vector<Pass> passes = {{8.0, 16.0, 0.0}};
  commit({{PutPasses{first, passes}, PutPasses{second, passes}}});
  commit({{TakeOut{{{{run.experience(), 0, 20}}, {}}}}});  // 2
  EXPECT_TRUE(finish(store_->compact({2})).finished);
  restart();
  EXPECT_EQ(stored_.passes, (std::map<RunPiece, std::vector<Pass>>{{second, passes}}));
}

TEST_P(MapUpkeep, ACheckOfASoundMapFindsNothingWhileCommitsGoOn) {
  sample::Run first(0x11, 1);
  sample::Run second(0xffff'ffff'0000'0001, 2);
  const auto feed = [&] {
    commit(sample::transaction(first.next(7)));
    auto joined = second.next(5);
    joined.batch.edges.push_back(sample::stitch({first.experience(), 2}, joined.batch.places.back().id));
    commit(sample::transaction(joined));
    commit({{PutLabel{"dock", joined.batch.places.front().id}, PutGoal{sample::goal(1, {first.experience(), 0})}}});
  };
  for (int i = 0; i < 40; ++i) feed();
  commit({{TakeOut{{{{first.experience(), 3, 5}}, {}}}}});
  commit({{RollBack{{30}}}});
  commit({{RollBack{{121}}}});
  const JobProgress progress = finish(store_->check(), [&] {
    commit({{PutLabel{"gate", {first.experience(), 1}}}});
  });
  EXPECT_TRUE(progress.findings.empty()) << progress.findings.front();
  EXPECT_GE(progress.done, 480U) << "contents alone";
  EXPECT_EQ(progress.done, progress.total);
  EXPECT_FALSE(progress.unit.empty());
  EXPECT_NE(progress.summary.find("nothing is damaged"), std::string::npos) << progress.summary;
}

TEST_P(MapUpkeep, ACheckNamesWhatAnEdgeMisses) {
  sample::Run run(0x11, 1);
  auto delivery = run.next(4);
  delivery.batch.edges.push_back(sample::stitch({{0x99}, 7}, {run.experience(), 2}));
  commit(sample::transaction(delivery));
  const JobProgress progress = finish(store_->check());
  ASSERT_EQ(progress.findings.size(), 1U);
  EXPECT_NE(progress.findings[0].find("edge " + to_string(PlaceId{{0x99}, 7}) + " - "), std::string::npos)
      << progress.findings[0];
}

TEST_P(MapUpkeep, AFinishedJobSaysSoAgain) {
  const auto job = store_->check().value();
  JobProgress last;
  while (!last.finished) last = job->step().value();
  EXPECT_TRUE(job->step().value().finished);
}

TEST_P(MapUpkeep, ASnapshotIsAFileOrRefused) {
  const TemporaryDirectory directory;
  sample::Run run(0x11, 1);
  commit(sample::transaction(run.next(4)));
  const auto file = directory.path() / "snapshot";
  auto job = store_->snapshot_to(file);
  if (!job) {
    EXPECT_EQ(job.error().code, ErrorCode::refused);
    EXPECT_EQ(store_->verify(file, at(1)).error().code, ErrorCode::refused);
    return;
  }
  EXPECT_NE(finish(std::move(job)).summary.find("revision 1"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(file));
  EXPECT_TRUE(finish(store_->verify(file, at(1))).findings.empty());
  EXPECT_EQ(store_->snapshot_to(file).error().code, ErrorCode::conflict);
}

INSTANTIATE_TEST_SUITE_P(Engines, MapUpkeep, all_engines(), engine_name);

}  // namespace
}  // namespace weft::storage
