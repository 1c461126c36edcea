#include <map>

#include "core/network/codec.hpp"
#include "tests/contract/map_store/store_fixture.hpp"
#include "tests/storage/random_history.hpp"
#include "tests/storage/sample_map.hpp"

/// Tests deleting for good: what the kept revisions need stays, to the last row; what they do not need goes.
namespace weft::storage {
namespace {

class MapCompaction : public StoreTest {
 protected:
  void expect_sound() {
    const JobProgress progress = finish(store_->check());
    EXPECT_TRUE(progress.findings.empty()) << progress.findings.front();
  }
  void compact(
      std::uint64_t before, const std::function<void()>& between = [] {}) {
    const JobProgress progress = finish(store_->compact({before}), between);
    EXPECT_NE(progress.summary.find("revision " + std::to_string(before) + " is the oldest"), std::string::npos)
        << progress.summary;
    EXPECT_EQ(store_->size().floor, Revision{before});
  }
  ErrorCode code_of(const auto& result) { return result ? ErrorCode::internal : result.error().code; }
};

TEST_P(MapCompaction, WhatIsOutSinceLongAgoGoesWithItsContents) {
  sample::Run run(0x11, 1);
  sample::Run other(0x22, 2);
  const auto first = run.next(8);
  commit(sample::transaction(first));
  auto joined = other.next(4);
  joined.batch.edges.push_back(sample::stitch({run.experience(), 2}, {other.experience(), 1}));
  joined.batch.edges.push_back(sample::stitch({run.experience(), 6}, {other.experience(), 2}));
  commit(sample::transaction(joined));
  commit({{PutLabel{"dock", {run.experience(), 0}}}});
  commit({{PutLabel{"dock", {run.experience(), 3}}}});
  commit({{TakeOut{{{{run.experience(), 2, 4}}, {joined.batch.edges.back().id}}}}});
  const auto before = sample::describe(at(5));
  compact(5);

  EXPECT_EQ(sample::describe(at(5)), before);
  EXPECT_EQ(store_->size().contents, 9U);
  for (const std::uint32_t gone : {2U, 3U, 4U}) {
    EXPECT_FALSE(store_->has_content(first.batch.places[gone].content.hash)) << gone;
  }
  EXPECT_TRUE(store_->has_content(first.batch.places[5].content.hash));
  expect_sound();
  restart();
  EXPECT_EQ(sample::describe(stored_.snapshot), before);
  EXPECT_TRUE(stored_.snapshot.labels().empty())
      << "the place of the label is out; its earlier meaning is no meaning";
  EXPECT_EQ(stored_.snapshot.experience(run.experience())->extent, 8U);
}

TEST_P(MapCompaction, OfWhatWasKnownOfAPlaceTheFirstAndTheLastStay) {
  sample::Run run(0x11, 1);
  const auto taught = run.next(2);
  commit(sample::transaction(taught));
  Place place = taught.batch.places[1];
  std::vector<Bytes> contents;
  for (std::uint8_t round = 0; round < 4; ++round) {
    contents.emplace_back(Bytes(100, round));
    place = sample::known_anew(place, contents.back(), sample::robot(2));
    commit({{PutContent{place.content.hash, msg::ContentKind::content, contents.back()}, PutPlaces{{place}}}});
  }
  compact(4);  // where the third lesson is known
  EXPECT_TRUE(store_->has_content(taught.batch.places[1].content.hash));
  EXPECT_FALSE(store_->has_content(hash_bytes(contents[0])));
  EXPECT_FALSE(store_->has_content(hash_bytes(contents[1])));
  EXPECT_TRUE(store_->has_content(hash_bytes(contents[2])));
  EXPECT_TRUE(store_->has_content(hash_bytes(contents[3])));
  EXPECT_EQ(at(4).place(place.id)->content.hash, hash_bytes(contents[2]));
  EXPECT_EQ(at(5).place(place.id)->content.hash, hash_bytes(contents[3]));
  expect_sound();
  commit({{TakeOut{{{{run.experience(), 1, 1}}, {}}}}});
  compact(6);
  EXPECT_FALSE(store_->has_content(hash_bytes(contents[3]))) << "it goes with its place";
  EXPECT_EQ(
      refusal({{PutContent{place.content.hash, msg::ContentKind::content, contents.back()}, PutPlaces{{place}}}}),
      ErrorCode::conflict);
  expect_sound();
}

TEST_P(MapCompaction, OlderRevisionsAreRefusedNamingTheOldest) {
  sample::Run run(0x11, 1);
  for (int i = 0; i < 6; ++i) commit(sample::transaction(run.next(2)));
  compact(4);
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(code_of(store_->snapshot_at({3}, {})), ErrorCode::not_found);
    EXPECT_NE(store_->snapshot_at({3}, {}).error().message.find("older than what is kept (revision 4)"),
              std::string::npos);
    EXPECT_EQ(code_of(store_->snapshot_at({0}, {})), ErrorCode::not_found);
    EXPECT_EQ(at(4).place_count(), 8U);
    EXPECT_EQ(code_of(store_->changes_of({3})), ErrorCode::not_found);
    EXPECT_EQ(code_of(store_->changes_of({4})), ErrorCode::not_found) << "what was before it is not known";
    EXPECT_EQ(changes(5).added, (Removal{{{run.experience(), 8, 9}}, {}}));
    EXPECT_EQ(code_of(store_->log({3}, 5)), ErrorCode::not_found);
    const auto log = store_->log({}, 100);
    ASSERT_TRUE(log);
    EXPECT_EQ(log->size(), 3U);
    EXPECT_EQ(log->back().revision, Revision{4});
    EXPECT_EQ(refusal({{RollBack{{3}}}}), ErrorCode::not_found);
    EXPECT_EQ(code_of(store_->compact({3})), ErrorCode::not_found);
    EXPECT_EQ(code_of(store_->compact({99})), ErrorCode::not_found);
    EXPECT_EQ(code_of(store_->compact({0})), ErrorCode::not_found);
    restart();
  }
  EXPECT_EQ(commit({{RollBack{{4}}}}), Revision{7});
  EXPECT_EQ(at(7).place_count(), 8U);
}

TEST_P(MapCompaction, WhatWasTakenOfARobotOnceIsNotTakenAgain) {
  sample::Run run(0x11, 1);
  const auto first = run.next(3);
  const auto second = run.next(3);
  commit(sample::transaction(first));
  commit(sample::transaction(second));
  commit({{RollBack{{1}}}});
  compact(3);
  EXPECT_FALSE(store_->has_content(second.batch.places[0].content.hash));
  EXPECT_EQ(store_->batch_hash(run.experience(), 2), hash(second.batch));
  EXPECT_EQ(commit(sample::transaction(second)), Revision{3}) << "a repeat is harmless";
  EXPECT_EQ(at(3).place_count(), 3U);
  const auto third = run.next(2);
  EXPECT_EQ(commit(sample::transaction(third)), Revision{4});
  restart();
  EXPECT_EQ(stored_.durable_through.at(run.experience()), 3U);
  EXPECT_EQ(stored_.snapshot.experience(run.experience())->extent, 8U) << "indices are given once";
  EXPECT_EQ(stored_.snapshot.place({run.experience(), 3}), nullptr);
  EXPECT_NE(stored_.snapshot.place({run.experience(), 6}), nullptr);
  expect_sound();
}

TEST_P(MapCompaction, WhatIsDeletedCannotComeBackOrBeNamed) {
  sample::Run run(0x11, 1);
  auto delivery = run.next(6);
  delivery.batch.edges.push_back(sample::stitch({run.experience(), 0}, {run.experience(), 4}));
  commit(sample::transaction(delivery));
  const Removal places{{{run.experience(), 1, 2}}, {}};
  const Removal stitch{{}, {delivery.batch.edges.back().id}};
  commit({{TakeOut{places}}});
  commit({{TakeOut{stitch}}});
  compact(3);
  EXPECT_EQ(refusal({{BringBack{places}}}), ErrorCode::conflict);
  EXPECT_EQ(refusal({{BringBack{stitch}}}), ErrorCode::conflict);
  EXPECT_EQ(refusal({{TakeOut{places}}}), ErrorCode::conflict);
  EXPECT_EQ(refusal({{PutLabel{"dock", {run.experience(), 1}}}}), ErrorCode::conflict);
  const Removal more{{{run.experience(), 0, 3}}, {}};
  EXPECT_EQ(commit({{TakeOut{more}}}), Revision{4}) << "a stretch may reach over what is gone";
  EXPECT_EQ(commit({{BringBack{more}}}), Revision{5});
  EXPECT_EQ(at(5).place_count(), 4U);
}

TEST_P(MapCompaction, EverythingAfterTheFloorCanStillBeUndone) {
  sample::Run run(0x11, 1);
  commit(sample::transaction(run.next(6)));
  commit({{PutLabel{"dock", {run.experience(), 1}}}});
  commit({{PutLabel{"dock", {run.experience(), 2}}}});
  commit({{TakeOut{{{{run.experience(), 1, 4}}, {}}}}});
  const auto before = at(3);
  compact(3);
  EXPECT_EQ(store_->size().contents, 6U);
  const auto changed = changes(4);
  commit({{BringBack{changed.taken_out}}});
  EXPECT_EQ(at(5).place_count(), 6U);
  EXPECT_EQ(at(5).labels(), before.labels());
  compact(4);
  EXPECT_EQ(at(5).place_count(), 6U) << "it is in again";
}

TEST_P(MapCompaction, AnEarlierRollbackBehindTheFloorKeepsWhatItNeeds) {
  sample::Run run(0x11, 1);
  const auto first = run.next(2);
  const auto second = run.next(2);
  commit(sample::transaction(first));
  commit(sample::transaction(second));
  commit({{TakeOut{{{{run.experience(), 0, 0}}, {}}}}});
  commit({{TakeOut{{{{run.experience(), 1, 1}}, {}}}}});
  commit({{RollBack{{1}}}});
  commit({{RollBack{{4}}}});
  const auto at_5 = sample::describe(at(5));
  const auto at_6 = sample::describe(at(6));
  compact(4);
  EXPECT_EQ(sample::describe(at(5)), at_5) << "places 0 and 1 of revision 1";
  EXPECT_EQ(sample::describe(at(6)), at_6);
  EXPECT_TRUE(store_->has_content(first.batch.places[0].content.hash));
  compact(6);
  EXPECT_EQ(sample::describe(at(6)), at_6);
  EXPECT_FALSE(store_->has_content(first.batch.places[0].content.hash));
  expect_sound();
}

/// Compacts a random history again and again while it goes on: no kept revision changes in anything.
TEST_P(MapCompaction, KeptRevisionsStayAsTheyWere) {
  for (const std::uint64_t seed : {71U, 72U, 73U}) {
    medium_ = GetParam().make_medium();
    restart();
    sample::RandomHistory history(seed);
    Random random(seed);
    std::map<std::uint64_t, std::vector<std::string>> seen;
    const auto play = [&] {
      const auto drawn = history.draw(stored_.snapshot, store_->size().floor);
      if (!drawn) return;
      const auto committed = store_->commit(drawn->transaction);
      if (!committed) {  // it brings back what was deleted
        ASSERT_EQ(committed.error().code, ErrorCode::conflict) << committed.error().message;
        return;
      }
      stored_.snapshot = at(committed->revision.value);
      seen[committed->revision.value] = sample::describe(stored_.snapshot);
    };
    std::uint64_t contents_gone = 0;
    for (int round = 0; round < 6; ++round) {
      for (int step = 0; step < 25; ++step) play();
      const std::uint64_t floor = store_->size().floor.value;
      const std::uint64_t newest = stored_.snapshot.revision().value;
      const std::uint64_t contents = store_->size().contents;
      compact(floor + 1 + random.below(newest - floor), play);
      contents_gone += contents > store_->size().contents ? 1 : 0;
      std::erase_if(seen, [&](const auto& entry) { return Revision{entry.first} < store_->size().floor; });
      for (const auto& [revision, lines] : seen) {
        ASSERT_EQ(sample::describe(at(revision)), lines) << "seed " << seed << ", revision " << revision;
      }
      expect_sound();
      restart();
      ASSERT_EQ(sample::describe(stored_.snapshot), seen.rbegin()->second);
    }
    EXPECT_GE(contents_gone, 1U) << "too little goes to show anything";
  }
}

TEST_P(MapCompaction, ContentsOfBatchesThatComeMeanwhileStay) {
  sample::Run run(0x11, 1);
  const auto first = run.next(30);
  commit(sample::transaction(first));
  commit({{TakeOut{{{{run.experience(), 0, 29}}, {}}}}});
  sample::Run again(0x11, 1);  // the same bytes
  const auto same = again.next(30);
  std::uint64_t id = 0x40;
  std::set<ContentHash> named;
  const auto teach_again = [&] {
    Batch batch = same.batch;
    const std::size_t at = (id - 0x40) % batch.places.size();
    batch.experience = {id++};
    batch.places = {batch.places[at]};
    batch.places[0].id = {batch.experience, 0};
    batch.edges.clear();
    Transaction transaction;
    if (!store_->has_content(batch.places[0].content.hash)) {
      transaction.changes.emplace_back(
          PutContent{batch.places[0].content.hash, msg::ContentKind::content, same.contents[at]});
    }
    transaction.changes.emplace_back(AppendBatch{batch, hash(batch)});
    commit(transaction);
    named.insert(batch.places[0].content.hash);
  };
  teach_again();
  compact(3, teach_again);
  for (const ContentHash& hash : named) EXPECT_TRUE(store_->content(hash));
  EXPECT_LT(named.size(), 30U);
  EXPECT_EQ(store_->size().contents, named.size());
  expect_sound();
}

TEST_P(MapCompaction, AJobThatIsDroppedLeavesASoundMapAndGoesOnLater) {
  sample::RandomHistory history(5);
  for (int step = 0; step < 60; ++step) {
    const auto drawn = history.draw(stored_.snapshot);
    if (drawn) stored_.snapshot = at(commit(drawn->transaction).value);
  }
  const std::uint64_t newest = stored_.snapshot.revision().value;
  const auto expected = sample::describe(at(newest));
  for (int steps = 0;; ++steps) {
    auto job = store_->compact({newest - 3});
    ASSERT_TRUE(job) << job.error().message;
    bool finished = false;
    for (int i = 0; i < steps && !finished; ++i) finished = (*job)->step()->finished;
    job->reset();
    expect_sound();
    restart();
    ASSERT_EQ(sample::describe(stored_.snapshot), expected) << "after " << steps << " steps";
    if (finished) break;
  }
}

TEST_P(MapCompaction, StatsCountWhatIsThere) {
  sample::Run run(0x11, 1);
  for (int i = 0; i < 10; ++i) commit(sample::transaction(run.next(5, 2000)));
  Random random(3);
  const Bytes cloud = sample::content(random, 3000);
  commit({{PutContent{hash_bytes(cloud), msg::ContentKind::cloud, cloud}, PutEvent{}}});
  const JobProgress progress = finish(store_->stats());
  const auto use = [&](const std::string& kind) {
    for (const SpaceUse& one : progress.space) {
      if (one.kind == kind) return one;
    }
    ADD_FAILURE() << kind;
    return SpaceUse{};
  };
  EXPECT_EQ(use("contents").count, 50U);
  EXPECT_EQ(use("contents").uncompressed_bytes, 100'000U);
  EXPECT_GT(use("contents").disk_bytes, 10'000U);
  EXPECT_LT(use("contents").disk_bytes, 110'000U);
  EXPECT_EQ(use("clouds").count, 1U);
  EXPECT_EQ(use("clouds").uncompressed_bytes, 3000U);
  EXPECT_EQ(use("events").count, 1U);
  EXPECT_GT(use("history").count, 5U);
  EXPECT_FALSE(progress.summary.empty());
}

INSTANTIATE_TEST_SUITE_P(Engines, MapCompaction, all_engines(), engine_name);

}  // namespace
}  // namespace weft::storage
