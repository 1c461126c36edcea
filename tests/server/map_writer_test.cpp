#include "server/base/map_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/network/codec.hpp"
#include "server/base/context.hpp"
#include "storage/memory/memory_store.hpp"
#include "tests/storage/sample_map.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;
namespace sample = storage::sample;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

template <class C>
concept CanServe = requires(C& context, Snapshot next) {
  context.snapshots.push(std::move(next));
};
template <class C>
concept CanStore = requires(C& context, storage::Transaction transaction) {
  context.store.commit(transaction);
};
static_assert(!CanServe<Context> && !CanStore<Context>, "the map has one writer");

struct MapWriting : testing::Test {
  MapWriting() {
    take(sample::transaction(run.next(10)));
    take(sample::transaction(other.next(10)));
    take(joining(other.next(5), run.experience()));
    out.take();
  }

  MapWriter::Served take(storage::Transaction transaction) {
    const auto served = writer.commit(std::move(transaction), now);
    EXPECT_TRUE(served) << served.error().message;
    EXPECT_EQ(served.value_or(nullptr), writer.snapshots().shared_current()) << "what is given back is served";
    expect_agreement();
    return served.value_or(nullptr);
  }
  Error refusal(storage::Transaction transaction) {
    const auto served = writer.commit(std::move(transaction), now);
    EXPECT_FALSE(served);
    return served ? Error{} : served.error();
  }
  /// Expects that everything that is served is stored, and the other way round.
  void expect_agreement() {
    const Snapshot& served = writer.snapshots().current();
    EXPECT_EQ(served.revision(), disk->revision);
    const auto stored = store->snapshot_at(disk->revision, Snapshot{});
    ASSERT_TRUE(stored) << stored.error().message;
    EXPECT_EQ(sample::describe(served), sample::describe(*stored));
    EXPECT_EQ(served.aparts(), stored->aparts());
  }
  static storage::Transaction joining(sample::Delivery delivery, ExperienceId with) {
    const PlaceId newer = delivery.batch.places.back().id;
    delivery.batch.edges.push_back(sample::stitch({with, 3}, newer));
    return sample::transaction(delivery);
  }
  Stretch places(const sample::Run& of, std::uint32_t first, std::uint32_t last) {
    return {of.experience(), first, last};
  }
  std::vector<std::string> told() {
    std::vector<std::string> kinds;
    for (const msg::Message& message : out.take()) kinds.push_back(std::get<msg::EventNote>(message).event.kind);
    return kinds;
  }
  static storage::PutEvent event(const std::string& kind) {
    return {{.at = {}, .kind = kind, .robot = {}, .goal = {}, .cause = "why", .who = "anna"}};
  }

  std::shared_ptr<storage::MemoryDisk> disk = std::make_shared<storage::MemoryDisk>();
  std::unique_ptr<storage::MapStore> store = storage::make_memory_store(disk);
  Outbox out{{}, 1, Epoch{1}};
  Counters counters;
  MapWriter writer{*store, store->open().value().snapshot, out, counters};
  Now now{.steady = SteadyTime(1000s), .wall = WallTime(5000s)};
  sample::Run run{1, 1};
  sample::Run other{2, 2};
};

TEST_F(MapWriting, ServesEachKindOfChangeAsItIsStored) {
  const PlaceId place{run.experience(), 2};
  const Apart apart = ordered({places(run, 0, 4), places(other, 0, 4)});
  take({{storage::PutLabel{"dock", place}}});
  take({{storage::PutLabel{"dock", {other.experience(), 1}}}});
  take({{storage::PutLabel{"dock", {}}}});
  take({{storage::PutApart{apart, true}}});
  take({{storage::PutApart{apart, false}}});
  take({{storage::TakeOut{{{places(run, 0, 3)}, {}}}}});
  take({{storage::PutApart{apart, true}, storage::PutLabel{"gate", {other.experience(), 0}}}});
  take({{storage::BringBack{{{places(run, 0, 3)}, {}}}}});
  take({{storage::SealExperience{.experience = run.experience(), .reason = "its end"}}});
  const Place before = *writer.snapshots().current().place(place);
  const Bytes better(50, 7);
  take({{storage::PutContent{hash_bytes(better), msg::ContentKind::content, better},
         storage::PutPlaces{{sample::known_anew(before, better, sample::robot(3))}}}});
  take({{storage::RollBack{{2}}}});
  EXPECT_EQ(writer.snapshots().current().experience_count(), 2U);
  EXPECT_EQ(writer.snapshots().current().stitch_count(), 0U);
}

TEST_F(MapWriting, ServesSeveralChangesOfOneTransactionAsOneRevision) {
  const Revision before = writer.snapshots().current().revision();
  storage::Transaction both = sample::transaction(run.next(4));
  for (auto& change : sample::transaction(other.next(4)).changes) both.changes.push_back(std::move(change));
  take(std::move(both));
  EXPECT_EQ(writer.snapshots().current().revision().value, before.value + 1);
  EXPECT_EQ(writer.snapshots().current().place_count(), 33U);
}

TEST_F(MapWriting, KeepsTheServedMapWhenNothingOfItChanges) {
  const MapWriter::Served before = writer.snapshots().shared_current();
  EXPECT_EQ(take({{event("goal.accepted"), storage::PutGoal{sample::goal(1, {run.experience(), 1})}}}), before);
  EXPECT_THAT(told(), ElementsAre("goal.accepted"));
  const storage::Transaction batch = sample::transaction(run.next(2));
  const MapWriter::Served joined = take(batch);
  EXPECT_NE(joined, before);
  EXPECT_EQ(take(batch), joined) << "a repeat joins once";
}

TEST_F(MapWriting, ServesNothingThatTheStoreHasNotTaken) {
  const MapWriter::Served before = writer.snapshots().shared_current();
  const storage::Transaction batch = sample::transaction(run.next(3));
  storage::Transaction told_batch = batch;
  told_batch.changes.emplace_back(event("experience.begun"));
  disk->faults.fail_next = 1;
  EXPECT_EQ(refusal(told_batch).code, ErrorCode::unavailable);
  EXPECT_EQ(writer.snapshots().shared_current(), before);
  EXPECT_THAT(told(), ElementsAre("store.stopped"));
  EXPECT_TRUE(writer.stopped());
  expect_agreement();
  EXPECT_EQ(refusal({{storage::PutLabel{"dock", {{77}, 0}}}}).code, ErrorCode::conflict);
  expect_agreement();
  EXPECT_NE(take(batch), before);
  EXPECT_FALSE(writer.stopped());
  EXPECT_FALSE(writer.broken());
}

TEST_F(MapWriting, EndsWhenWhatIsStoredCannotBeServed) {
  take({{storage::TakeOut{{{places(run, 0, 3)}, {}}}}});
  const MapWriter::Served before = writer.snapshots().shared_current();
  disk->floor = Revision{1000};  // the store has every revision, and shows none
  const Error error = refusal({{storage::BringBack{{{places(run, 0, 3)}, {}}}, event("map.undo")}});
  EXPECT_THAT(error.message, HasSubstr("it is stored as revision 5; the server has to start anew"));
  EXPECT_EQ(disk->revision, Revision{5});
  EXPECT_EQ(writer.unserved(), Revision{5});
  EXPECT_EQ(writer.snapshots().shared_current(), before);
  EXPECT_THAT(told(), ElementsAre("map.undo")) << "it is stored";
  ASSERT_TRUE(writer.broken());
  EXPECT_THAT(writer.broken()->message, HasSubstr("the server has to start anew"));
  disk->floor = {};
  EXPECT_EQ(refusal({{storage::PutLabel{"dock", {other.experience(), 0}}}}).message, writer.broken()->message);
  EXPECT_EQ(disk->revision, Revision{5}) << "nothing is stored any more either";
}

TEST_F(MapWriting, EndsWhenAnotherServerHasTheStore) {
  const MapWriter::Served before = writer.snapshots().shared_current();
  const auto next_server = storage::make_memory_store(disk);
  ASSERT_TRUE(next_server->open());
  EXPECT_EQ(refusal(sample::transaction(run.next(3))).code, ErrorCode::stale);
  EXPECT_EQ(writer.broken().value().code, ErrorCode::stale);
  EXPECT_FALSE(writer.unserved());
  EXPECT_EQ(writer.snapshots().shared_current(), before);
}

TEST_F(MapWriting, SaysThatTheStoreWorksAgainThoughNobodyWrites) {
  disk->faults.full = true;
  EXPECT_EQ(refusal(sample::transaction(run.next(3))).code, ErrorCode::exhausted);
  EXPECT_THAT(told(), ElementsAre("store.stopped"));
  ASSERT_TRUE(writer.next());
  now.steady = *writer.next();
  writer.tick(now);
  EXPECT_TRUE(writer.stopped()) << "the disk is full still";
  EXPECT_THAT(told(), IsEmpty());
  EXPECT_GT(*writer.next(), now.steady);
  disk->faults.full = false;
  writer.tick(now);
  EXPECT_TRUE(writer.stopped()) << "not before it is time";
  now.steady = *writer.next();
  writer.tick(now);
  EXPECT_FALSE(writer.stopped());
  EXPECT_FALSE(writer.next());
  EXPECT_THAT(told(), ElementsAre("store.works_again"));
  const auto kept = store->events({.kind = "store"}, 10);
  ASSERT_TRUE(kept);
  ASSERT_EQ(kept->events.size(), 1U);
  EXPECT_EQ(kept->events.front().kind, "store.works_again") << "what it could not keep is told alone";
}

TEST_F(MapWriting, ToldEventsSayWhetherTheyAreKept) {
  const auto are_kept = [this] {
    std::vector<bool> kept;
    for (const msg::Message& message : out.take()) kept.push_back(std::get<msg::EventNote>(message).is_kept);
    return kept;
  };
  writer.note(event("robot.silent").event, now);
  EXPECT_THAT(are_kept(), ElementsAre(true));
  disk->faults.fail_next = 1;
  writer.note(event("robot.silent").event, now);
  EXPECT_THAT(are_kept(), ElementsAre(false, false)) << "store.stopped, and what was noted";
}

}  // namespace
}  // namespace weft::server
