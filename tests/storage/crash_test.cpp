#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "storage/spool/file_spool.hpp"
#include "storage/sqlite/sqlite_store.hpp"
#include "tests/storage/killed_child.hpp"
#include "tests/storage/sample_map.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::storage {
namespace {

constexpr int kRounds = 12;
constexpr int kMostBatches = 10'000;
constexpr std::uint32_t kPlaces = 3;

std::vector<sample::Delivery> deliveries(std::uint64_t count) {
  sample::Run run(1, 1);
  std::vector<sample::Delivery> all;
  for (std::uint64_t at = 0; at < count; ++at) all.push_back(run.next(kPlaces, 3000));
  return all;
}

/// Does the child's work: continues the run where the store ends, reports each batch that was acknowledged.
void commit_for_ever(const std::filesystem::path& directory, const std::function<void(std::uint64_t)>& report) {
  auto store = open_sqlite(directory);
  if (!store) return;
  const auto stored = (*store)->open();
  if (!stored) return;
  const auto found = stored->durable_through.find({1});
  const std::uint64_t from = found == stored->durable_through.end() ? 0 : found->second;
  sample::Run run(1, 1);
  for (std::uint64_t sequence = 1; sequence <= kMostBatches; ++sequence) {
    const auto delivery = run.next(kPlaces, 3000);
    if (sequence <= from) continue;
    if (!(*store)->commit(sample::transaction(delivery))) return;
    report(sequence);
  }
}

TEST(Crash, KilledServerHasEveryAcknowledgedBatchOnceAndNothingHalf) {
  const TemporaryDirectory directory;
  Random random(20);
  for (int round = 1; round <= kRounds; ++round) {
    const auto acknowledged =
        run_and_kill(1 + static_cast<int>(random.below(6)), static_cast<unsigned>(random.below(4000)),
                     [&](const auto& report) { commit_for_ever(directory.path(), report); });
    ASSERT_GT(acknowledged, 0U) << "the child could not commit";

    auto store = open_sqlite(directory.path());
    ASSERT_TRUE(store) << store.error().message;
    const auto stored = (*store)->open();
    ASSERT_TRUE(stored) << stored.error().message;
    EXPECT_EQ(stored->epoch, Epoch{std::uint64_t{2} * static_cast<unsigned>(round)});
    EXPECT_TRUE(stored->quarantined.empty());
    const std::uint64_t durable = stored->durable_through.at({1});
    EXPECT_GE(durable, acknowledged);
    EXPECT_LE(durable, acknowledged + 1) << "at most the batch under way is there unacknowledged";
    EXPECT_EQ(stored->snapshot.revision(), Revision{durable}) << "revisions have no gap";
    EXPECT_EQ(stored->snapshot.place_count(), durable * kPlaces);
    EXPECT_EQ((*store)->size().contents, durable * kPlaces);
    for (const auto& delivery : deliveries(durable)) {
      EXPECT_EQ((*store)->batch_hash({1}, delivery.batch.sequence), hash(delivery.batch));
      for (const Bytes& bytes : delivery.contents) {
        const auto read = (*store)->content(hash_bytes(bytes));
        ASSERT_TRUE(read) << read.error().message;
        EXPECT_EQ(*read, bytes);
      }
    }
  }
}

/// Does the child's work: appends batch after batch, acknowledges the first two, reports each append.
void spool_for_ever(const std::filesystem::path& directory, const std::function<void(std::uint64_t)>& report) {
  auto spool = open_file_spool(directory);
  if (!spool) return;
  sample::Run run(1, 1);
  for (std::uint64_t sequence = 1; sequence <= kMostBatches; ++sequence) {
    const auto delivery = run.next(kPlaces, 3000);
    if (!(*spool)->append(delivery.batch, delivery.contents)) return;
    report(sequence);
    if (sequence == 3 && !(*spool)->acknowledged({1}, 2)) return;
  }
}

TEST(Crash, KilledAgentHasEveryAppendedBatchInItsSpool) {
  Random random(21);
  for (int round = 1; round <= kRounds; ++round) {
    const TemporaryDirectory directory;
    const auto appended =
        run_and_kill(4 + static_cast<int>(random.below(20)), static_cast<unsigned>(random.below(2000)),
                     [&](const auto& report) { spool_for_ever(directory.path(), report); });
    ASSERT_GT(appended, 3U) << "the child could not append";

    auto spool = open_file_spool(directory.path());
    ASSERT_TRUE(spool) << spool.error().message;
    EXPECT_TRUE((*spool)->skipped().empty());
    const auto pending = (*spool)->pending();
    ASSERT_TRUE(pending);
    ASSERT_GE(pending->size(), appended - 2);
    ASSERT_LE(pending->size(), appended - 1);
    for (const auto& delivery : deliveries(pending->size() + 2)) {
      if (delivery.batch.sequence <= 2) continue;
      EXPECT_EQ(hash((*pending)[delivery.batch.sequence - 3]), hash(delivery.batch));
      for (const Bytes& bytes : delivery.contents) EXPECT_EQ((*spool)->content(hash_bytes(bytes)).value(), bytes);
    }
    for (const auto& entry : std::filesystem::directory_iterator(directory.path())) {
      EXPECT_EQ(entry.path().extension(), ".batch") << entry.path();
    }
  }
}

}  // namespace
}  // namespace weft::storage
