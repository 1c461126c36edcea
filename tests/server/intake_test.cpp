#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <limits>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct Intake : testing::Test {
  Intake() { site.arrive(r1, std::nullopt); }
  msg::BatchAck ack() { return site.last<msg::BatchAck>().value(); }
  const Experience* stored(const TaughtRun& of) { return site.service().snapshot().experience(of.id()); }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  TaughtRun run{r1, 10};
};

TEST_F(Intake, BatchIsDurableOnlyWithItsContents) {
  const Handed handed = run.next(2);
  site.send_batch(r1, handed.batch);
  EXPECT_EQ(ack().durable_through, 0U);
  EXPECT_THAT(ack().missing, SizeIs(2));
  site.send_content(r1, handed.contents[1]);
  EXPECT_EQ(stored(run), nullptr);
  site.send_batch(r1, handed.batch);
  EXPECT_THAT(ack().missing, ElementsAre(handed.batch.places[0].content.hash));
  site.send_content(r1, handed.contents[0]);
  EXPECT_EQ(ack().durable_through, 1U);
  EXPECT_THAT(ack().missing, IsEmpty());
  EXPECT_EQ(stored(run)->places.size(), 2U);
  EXPECT_EQ(site.disk->contents.size(), 2U);
}

TEST_F(Intake, ContentThatWasStoredAndWentMeanwhileIsAskedForAgain) {
  const Handed before = run.next(1);
  site.hand_in(r1, before);
  TaughtRun other(r1, 11);
  Handed handed = other.next(2);
  handed.batch.places[0].content = before.batch.places[0].content;
  site.send_batch(r1, handed.batch);
  EXPECT_THAT(ack().missing, ElementsAre(handed.batch.places[1].content.hash));
  site.disk->contents.erase(before.batch.places[0].content.hash);
  site.send_content(r1, handed.contents[1]);
  EXPECT_EQ(stored(other), nullptr);
  EXPECT_THAT(ack().missing, ElementsAre(before.batch.places[0].content.hash));
  EXPECT_EQ(ack().refused_sequence, 0U);
  site.send_content(r1, before.contents[0]);
  EXPECT_EQ(ack().durable_through, 1U);
  EXPECT_EQ(stored(other)->places.size(), 2U);
}

TEST_F(Intake, RepeatIsHarmlessAndAnsweredAlike) {
  const Handed handed = run.next(2);
  site.hand_in(r1, handed);
  const Revision before = site.service().snapshot().revision();
  site.hush();
  site.hand_in(r1, handed);
  EXPECT_EQ(ack().durable_through, 1U);
  EXPECT_EQ(ack().refused_sequence, 0U);
  EXPECT_EQ(site.service().snapshot().revision(), before);
}

TEST_F(Intake, SameSequenceWithAnotherHashIsRefusedCountedAndTold) {
  Handed handed = run.next(2);
  site.hand_in(r1, handed);
  handed.batch.name = "another";
  site.send_batch(r1, handed.batch);
  site.send_batch(r1, handed.batch);
  EXPECT_EQ(ack().refused_sequence, 1U);
  EXPECT_THAT(ack().refusal, HasSubstr("another hash"));
  EXPECT_EQ(ack().durable_through, 1U);
  EXPECT_THAT(site.events_of("intake.refused"), SizeIs(1)) << "a repeat is not told again";
}

TEST_F(Intake, BatchesThatOvertakeEachOtherAreTakenInOrder) {
  const Handed first = run.next(2);
  const Handed second = run.next(2);
  site.hand_in(r1, second);
  EXPECT_EQ(ack().durable_through, 0U);
  site.hand_in(r1, first);
  EXPECT_EQ(ack().durable_through, 2U);
  EXPECT_EQ(stored(run)->places.size(), 4U);
}

TEST_F(Intake, ChunksMayComeDoubledAndOutOfOrder) {
  const Handed handed = run.next(1, 3 * msg::kChunkBytes + 17);
  const Bytes& content = handed.contents[0];
  site.send_batch(r1, handed.batch);
  for (const std::size_t index : {2U, 0U, 2U, 3U, 0U, 1U}) {
    EXPECT_EQ(stored(run), nullptr);
    const std::size_t offset = index * msg::kChunkBytes;
    const std::size_t size = std::min(msg::kChunkBytes, content.size() - offset);
    const auto begin = content.begin() + static_cast<std::ptrdiff_t>(offset);
    site.say(msg::Chunk{.header = r1.header(),
                        .to = {},
                        .kind = msg::ContentKind::content,
                        .coding = msg::Coding::raw,
                        .hash = handed.batch.places[0].content.hash,
                        .total = content.size(),
                        .offset = offset,
                        .data = Bytes(begin, begin + static_cast<std::ptrdiff_t>(size))});
  }
  EXPECT_EQ(ack().durable_through, 1U);
}

TEST_F(Intake, BytesThatAreNotWhatWasPromisedAreRefusedAndAskedForAgain) {
  const Handed handed = run.next(1);
  site.send_batch(r1, handed.batch);
  msg::Chunk chunk;
  chunk.header = r1.header();
  chunk.hash = handed.batch.places[0].content.hash;
  chunk.total = handed.contents[0].size();
  chunk.data = Bytes(handed.contents[0].size(), 0xEE);
  site.say(chunk);
  EXPECT_EQ(stored(run), nullptr);
  EXPECT_THAT(site.events_of("intake.content_refused"), SizeIs(1));
  site.hand_in(r1, handed);
  EXPECT_EQ(ack().durable_through, 1U);
}

TEST_F(Intake, ChunkThatIsNotRawIsRefusedAndCounted) {
  const Handed handed = run.next(1);
  site.send_batch(r1, handed.batch);
  msg::Chunk chunk;
  chunk.header = r1.header();
  chunk.coding = msg::Coding::zstd;
  chunk.hash = handed.batch.places[0].content.hash;
  chunk.total = handed.contents[0].size();
  chunk.data = handed.contents[0];
  site.say(chunk);
  EXPECT_EQ(stored(run), nullptr);
  EXPECT_EQ(site.counted("intake: chunk that is not raw"), 1U);
  site.hand_in(r1, handed);
  EXPECT_EQ(ack().durable_through, 1U);
}

TEST_F(Intake, ChunkOutsideOfItsContentDoesNothing) {
  const Handed handed = run.next(1);
  site.send_batch(r1, handed.batch);
  msg::Chunk chunk;
  chunk.header = r1.header();
  chunk.hash = handed.batch.places[0].content.hash;
  chunk.total = handed.contents[0].size();
  chunk.offset = UINT64_MAX - 3;
  chunk.data = Bytes(10, 1);
  site.say(chunk);
  site.hand_in(r1, handed);
  EXPECT_EQ(ack().durable_through, 1U);
}

TEST_F(Intake, BatchThatCannotJoinIsRefusedWithTheReason) {
  Handed handed = run.next(2);
  handed.batch.edges.clear();
  site.hand_in(r1, handed);
  EXPECT_EQ(ack().refused_sequence, 1U);
  EXPECT_FALSE(ack().refusal.empty());
  EXPECT_EQ(stored(run), nullptr);
}

// Each kind by itself is named in tests/core/change_test.cpp, and at the wire in tests/idl/validation_test.cpp.
TEST_F(Intake, MalformedBatchesAreCountedAndLeaveNoTrace) {
  site.hand_in(r1, run.next(5));
  const Revision before = site.service().snapshot().revision();
  const std::vector<std::function<void(Batch&)>> damages = {
      [](Batch& b) { b.places[1].id.experience = {300}; },
      [](Batch& b) { std::get<Metric2>(b.edges[0].a_from_b).a_from_b.x = std::numeric_limits<double>::quiet_NaN(); },
      [](Batch& b) {
        Metric3 turned;
        turned.a_from_b.rotation = Eigen::Quaterniond(3.0, 0.0, 0.0, 0.0);  // no rotation
        b.edges[0].a_from_b = turned;
      },
      [](Batch& b) { std::swap(b.edges[0].id.a, b.edges[0].id.b); },
      [](Batch& b) {
        b.edges[0].id.a = {ExperienceId{77}, 3};
      },
      [](Batch& b) { b.name.assign(100'000'000, 'x'); },
      [](Batch& b) { b.places[0].content.size = ~0ULL; },
  };
  std::uint64_t refused = 0;
  std::uint64_t experience = 500;
  for (const auto& damage : damages) {
    TaughtRun other(r1, ++experience);
    Handed handed = other.next(3);
    damage(handed.batch);
    site.hush();
    site.hand_in(r1, handed);
    EXPECT_FALSE(ack().refusal.empty()) << "damage " << refused;
    EXPECT_LT(ack().refusal.size(), 3000U);
    EXPECT_EQ(site.events_of("intake.refused").size(), ++refused);
    EXPECT_EQ(stored(other), nullptr);
  }
  Handed repeat = run.next(1);
  repeat.batch.sequence = 1;
  site.hand_in(r1, repeat);
  EXPECT_EQ(site.events_of("intake.refused").size(), ++refused) << "a repeat with other content";
  EXPECT_EQ(site.service().snapshot().revision(), before);
  EXPECT_EQ(site.service().snapshot().place_count(), 5U);
}

TEST_F(Intake, BatchOfAnotherRobotIsNotTaken) {
  Peer r2{.id = robot_id(2), .name = "r2"};
  site.arrive(r2, std::nullopt);
  const Handed handed = run.next(2);
  site.hand_in(r2, handed);
  EXPECT_EQ(stored(run), nullptr);
  EXPECT_THAT(site.heard<msg::BatchAck>(), IsEmpty());
}

TEST_F(Intake, FullDiskStopsIntakeVisiblyUntilItHasRoom) {
  site.disk->faults.full = true;
  const Handed handed = run.next(2);
  site.hand_in(r1, handed);
  EXPECT_EQ(ack().durable_through, 0U);
  bool is_told = false;
  for (const msg::EventNote& note : site.heard<msg::EventNote>()) is_told |= note.event.kind == "store.stopped";
  EXPECT_TRUE(is_told);
  site.pass(10s);
  EXPECT_EQ(stored(run), nullptr);
  site.disk->faults.full = false;
  site.pass(10s);
  EXPECT_EQ(ack().durable_through, 1U);
  EXPECT_THAT(site.events_of("store.works_again"), SizeIs(1));
}

TEST_F(Intake, RestartKnowsWhatIsDurable) {
  site.hand_in(r1, run.next(2));
  const Handed second = run.next(2);
  site.send_batch(r1, second.batch);
  site.restart();
  EXPECT_EQ(stored(run)->places.size(), 2U);
  site.hand_in(r1, second);
  EXPECT_EQ(ack().durable_through, 2U);
}

TEST_F(Intake, ExperienceLeftOpenByARestartIsSealedWhenAnotherBegins) {
  site.hand_in(r1, run.next(2));
  r1.incarnation = 2;
  TaughtRun other(r1, 11);
  site.hand_in(r1, other.next(2));
  EXPECT_TRUE(stored(run)->sealed);
  EXPECT_THAT(stored(run)->seal_reason, HasSubstr("restart"));
  EXPECT_FALSE(stored(other)->sealed);
}

TEST_F(Intake, OpenExperienceOfTheSameIncarnationIsLeftToItsRobot) {
  site.hand_in(r1, run.next(2));
  TaughtRun other(r1, 11);
  site.hand_in(r1, other.next(2));
  EXPECT_FALSE(stored(run)->sealed) << "its seal may still be on the way";
  site.hand_in(r1, run.seal());
  EXPECT_TRUE(stored(run)->sealed);
  EXPECT_EQ(stored(run)->seal_reason, "the operator ended it");
}

}  // namespace
}  // namespace weft::server::test
