#include <gtest/gtest.h>

#include <map>

#include "core/network/codec.hpp"
#include "tests/contract/map_store/store_fixture.hpp"
#include "tests/storage/random_history.hpp"
#include "tests/storage/sample_map.hpp"

/// Tests the map's past: every revision can be seen again, gone back to, and undone; no acknowledged change is lost.
namespace weft::storage {
namespace {

using MapHistory = StoreTest;

TEST_P(MapHistory, WhatIsTakenOutLeavesWithItsEdgesAndLabelsAndComesBackWithThem) {
  sample::Run old(0x11, 1);
  sample::Run young(0x22, 2);
  commit(sample::transaction(old.next(6)));
  auto joined = young.next(4);
  joined.batch.edges.push_back(sample::stitch({old.experience(), 2}, {young.experience(), 1}));
  commit(sample::transaction(joined));
  commit({{PutLabel{"dock", {old.experience(), 2}}}});

  commit({{TakeOut{{{{old.experience(), 2, 3}}, {}}}}});
  const Snapshot out = at(4);
  EXPECT_EQ(out.place_count(), 8U);
  EXPECT_EQ(out.stitch_count(), 0U);
  EXPECT_TRUE(out.labels().empty());
  EXPECT_EQ(out.place({old.experience(), 2}), nullptr);
  ASSERT_NE(out.place({old.experience(), 4}), nullptr);
  EXPECT_EQ(out.experience(old.experience())->hop(1), nullptr) << "an edge to a place that is out";
  EXPECT_NE(out.experience(old.experience())->hop(4), nullptr);
  EXPECT_EQ(sample::describe(without(at(3), {{{old.experience(), 2, 3}}, {}})), sample::describe(out));

  commit({{BringBack{{{{old.experience(), 2, 3}}, {}}}}});
  auto back = sample::describe(at(5));
  auto before = sample::describe(at(3));
  back.erase(back.begin());  // the revision
  before.erase(before.begin());
  EXPECT_EQ(back, before);
}

TEST_P(MapHistory, AStitchThatIsTakenOutCanBeMadeAnew) {
  sample::Run run(0x11, 1);
  commit(sample::transaction(run.next(6)));
  const Edge stitch = sample::stitch({run.experience(), 0}, {run.experience(), 4});
  auto second = run.next(1);
  second.batch.edges.push_back(stitch);
  commit(sample::transaction(second));
  commit({{TakeOut{{{}, {stitch.id}}}}});
  EXPECT_EQ(at(3).stitch_count(), 0U);
  auto third = run.next(1);
  third.batch.edges.push_back(stitch);
  commit(sample::transaction(third));
  EXPECT_EQ(at(4).stitch_count(), 1U);
  restart();
  EXPECT_EQ(stored_.snapshot.stitch_count(), 1U);
}

/// Arranges a run whose place 1 is learned twice, by another robot's batch and by an edit.
struct Learned {
  sample::Run run{0x11, 1};
  sample::Run lessons{0x22, 2};
  Bytes better = Bytes(100, 0x41);
  Bytes best = Bytes(120, 0x42);
  sample::Delivery taught = run.next(3);
  Place second = sample::known_anew(taught.batch.places[1], better, sample::robot(2));
  Place third = sample::known_anew(second, best, sample::robot(3));

  sample::Delivery lesson() {
    sample::Delivery delivery = lessons.next(0);
    delivery.batch.learned = {second};
    delivery.contents = {better};
    return delivery;
  }
  Transaction edit() const {
    return {{PutContent{hash_bytes(best), msg::ContentKind::content, best}, PutPlaces{{third}}}};
  }
};

TEST_P(MapHistory, APlaceThatIsKnownBetterIsSeenAsItWasKnownAtEachRevision) {
  Learned all;
  commit(sample::transaction(all.taught));
  commit(sample::transaction(all.lesson()));
  commit(all.edit());
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(*at(1).place(all.second.id), all.taught.batch.places[1]);
    EXPECT_EQ(*at(2).place(all.second.id), all.second);
    EXPECT_EQ(*at(3).place(all.second.id), all.third);
    EXPECT_EQ(*at(2, at(3)).place(all.second.id), all.second);
    EXPECT_EQ(*at(3, at(1)).place(all.second.id), all.third);
    EXPECT_EQ(at(3).place_count(), 3U);
    EXPECT_EQ(changes(2).known_anew, std::vector{all.second});
    EXPECT_EQ(changes(3).known_anew, std::vector{all.third});
    EXPECT_TRUE(changes(2).added.empty()) << "a batch of lessons adds no place";
    EXPECT_EQ(store_->log({2}, 1).value().front().kind, "learned");
    restart();
    EXPECT_EQ(*stored_.snapshot.place(all.second.id), all.third);
  }
  commit({{RollBack{{2}}}});
  EXPECT_EQ(*at(4).place(all.second.id), all.second);
  restart();
  EXPECT_EQ(*stored_.snapshot.place(all.second.id), all.second);
}

TEST_P(MapHistory, OnlyWhatIsStoredIsKnownAnew) {
  Learned all;
  commit(sample::transaction(all.taught));
  EXPECT_EQ(refusal({{PutPlaces{{all.second}}}}), ErrorCode::conflict) << "its content is not there";
  const PutContent content{hash_bytes(all.better), msg::ContentKind::content, all.better};
  Place wrong = all.second;
  wrong.id.index = 7;
  EXPECT_EQ(refusal({{content, PutPlaces{{wrong}}}}), ErrorCode::conflict);
  wrong = all.second;
  wrong.entity_version = 1;
  EXPECT_EQ(refusal({{content, PutPlaces{{wrong}}}}), ErrorCode::invalid);
  EXPECT_FALSE(store_->has_content(content.hash)) << "nothing half written";
}

TEST_P(MapHistory, RollbackIsARevisionAndLosesNothing) {
  sample::Run run(0x11, 1);
  commit(sample::transaction(run.next(3)));
  const auto second = run.next(3);
  commit(sample::transaction(second));
  EXPECT_EQ(commit({{RollBack{{1}}}}), Revision{3});
  restart();
  EXPECT_EQ(stored_.snapshot.revision(), Revision{3});
  EXPECT_EQ(stored_.snapshot.place_count(), 3U);
  EXPECT_EQ(stored_.snapshot.experience(run.experience())->extent, 6U) << "indices are given once";
  EXPECT_EQ(store_->batch_hash(run.experience(), 2), hash(second.batch)) << "what was acknowledged stays";
  EXPECT_TRUE(store_->has_content(hash_bytes(second.contents.front())));
  EXPECT_EQ(commit({{RollBack{{2}}}}), Revision{4}) << "and can be gone back to";
  EXPECT_EQ(at(4).place_count(), 6U);
}

TEST_P(MapHistory, TheLogNamesEachRevisionWithoutAGap) {
  sample::Run run(0x11, 1);
  commit(sample::transaction(run.next(3)));
  commit({{PutLabel{"dock", {run.experience(), 1}}}});
  Transaction undo{{TakeOut{{{{run.experience(), 0, 0}}, {}}}}, {}};
  undo.note.at = WallTime(std::chrono::seconds(5));
  undo.note.kind = "undo";
  undo.note.who = "anna";
  undo.note.cause = "the floor is new";
  commit(undo);
  commit({{RollBack{{2}}}});
  restart();
  const auto log = store_->log({}, 100);
  ASSERT_TRUE(log);
  ASSERT_EQ(log->size(), 4U);
  for (std::size_t i = 0; i < log->size(); ++i) EXPECT_EQ((*log)[i].revision.value, 4 - i);
  EXPECT_EQ((*log)[0].kind, "rollback");
  EXPECT_EQ((*log)[0].base, Revision{2});
  EXPECT_EQ((*log)[1].who, "anna");
  EXPECT_EQ((*log)[1].cause, "the floor is new");
  EXPECT_EQ((*log)[1].at, WallTime(std::chrono::seconds(5)));
  EXPECT_EQ((*log)[2].cause, "dock is 0000000000000011:1");
  EXPECT_EQ((*log)[3].kind, "batch");
  EXPECT_EQ(store_->log({2}, 1)->front().revision, Revision{2});
}

TEST_P(MapHistory, ChangesOfARevisionAreWhatUndoesIt) {
  sample::Run run(0x11, 1);
  commit(sample::transaction(run.next(4)));
  commit({{PutLabel{"dock", {run.experience(), 1}}}});
  commit({{PutLabel{"dock", {run.experience(), 2}}, PutLabel{"gate", {run.experience(), 0}}}});
  auto second = run.next(2);
  second.batch.edges.push_back(sample::stitch({run.experience(), 0}, {run.experience(), 5}));
  commit(sample::transaction(second));
  commit({{TakeOut{{{{run.experience(), 1, 1}}, {second.batch.edges.back().id}}}}});

  EXPECT_EQ(changes(4).added, (Removal{{{run.experience(), 4, 5}}, {second.batch.edges.back().id}}));
  EXPECT_EQ(changes(5).taken_out, (Removal{{{run.experience(), 1, 1}}, {second.batch.edges.back().id}}));
  EXPECT_TRUE(changes(5).added.empty());
  EXPECT_EQ(changes(3).labels, (std::set<std::string>{"dock", "gate"}));
  EXPECT_EQ(at(2).labels(), (Snapshot::Labels{{"dock", {run.experience(), 1}}}));

  commit({{PutLabel{"dock", {run.experience(), 1}}, PutLabel{"gate", {}}}});
  EXPECT_FALSE(at(6).labels().contains("gate"));
  EXPECT_FALSE(at(6).labels().contains("dock")) << "its place is out";
  commit({{BringBack{changes(5).taken_out}}});
  EXPECT_EQ(at(7).labels().at("dock"), (PlaceId{run.experience(), 1}));
}

/// Tests that such a label waits for its place, as one whose place was taken out does.
TEST_P(MapHistory, ALabelOfAPlaceThatARollbackLeftBehindIsNoDamage) {
  sample::Run run(0x11, 1);
  commit(sample::transaction(run.next(2)));
  commit(sample::transaction(run.next(2)));
  commit({{RollBack{{1}}}});
  commit({{PutLabel{"dock", {run.experience(), 3}}}});
  restart();
  EXPECT_TRUE(stored_.snapshot.labels().empty());
  EXPECT_EQ(stored_.snapshot.place_count(), 2U);
}

TEST_P(MapHistory, WhatCannotBeIsRefused) {
  sample::Run run(0x11, 1);
  commit(sample::transaction(run.next(3)));
  EXPECT_EQ(refusal({{TakeOut{{{{run.experience(), 2, 3}}, {}}}}}), ErrorCode::conflict);
  EXPECT_EQ(refusal({{TakeOut{{{{run.experience(), 2, 1}}, {}}}}}), ErrorCode::conflict);
  EXPECT_EQ(refusal({{RollBack{{1}}}}), ErrorCode::conflict) << "it is the newest";
  EXPECT_EQ(refusal({{RollBack{{9}}}}), ErrorCode::conflict);
  EXPECT_EQ(refusal({{PutLabel{"dock", {run.experience(), 0}}, RollBack{{0}}}}), ErrorCode::invalid);
  EXPECT_EQ(store_->snapshot_at({7}, {}).error().code, ErrorCode::not_found);
  EXPECT_EQ(store_->changes_of({7}).error().code, ErrorCode::not_found);
  EXPECT_EQ(at(0).place_count(), 0U);
}

/// Steps as a server would take them, each checked against the snapshot in memory, then all of the past once more.
TEST_P(MapHistory, EveryRevisionCanBeSeenAgain) {
  sample::RandomHistory history(31);
  std::map<std::uint64_t, std::vector<std::string>> seen;
  for (int step = 0; step < 120; ++step) {
    const auto drawn = history.draw(stored_.snapshot);
    if (!drawn) continue;
    const Revision revision = commit(drawn->transaction);
    stored_.snapshot = at(revision.value);
    if (drawn->expected) {
      ASSERT_EQ(sample::describe(*drawn->expected), sample::describe(stored_.snapshot)) << "step " << step;
    }
    seen[revision.value] = sample::describe(stored_.snapshot);
  }
  ASSERT_GT(seen.size(), 60U);
  restart();
  EXPECT_EQ(sample::describe(stored_.snapshot), seen.rbegin()->second);
  for (const auto& [revision, lines] : seen) ASSERT_EQ(sample::describe(at(revision)), lines) << revision;
}

INSTANTIATE_TEST_SUITE_P(Engines, MapHistory, all_engines(), engine_name);

}  // namespace
}  // namespace weft::storage
