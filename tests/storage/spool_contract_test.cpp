#include <gtest/gtest.h>

#include <filesystem>

#include "core/network/codec.hpp"
#include "storage/spool/file_spool.hpp"
#include "storage/spool/memory_spool.hpp"
#include "tests/storage/sample_map.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::storage {
namespace {

enum class Kind { memory, file };

/// Tests what every spool keeps to.
class SpoolContract : public testing::TestWithParam<Kind> {
 protected:
  void SetUp() override { restart(); }
  void restart() {
    spool_.reset();
    if (GetParam() == Kind::memory) {
      spool_ = make_memory_spool(disk_);
    } else {
      auto opened = open_file_spool(directory_.path() / "spool");
      ASSERT_TRUE(opened) << opened.error().message;
      spool_ = std::move(*opened);
    }
  }
  void append(const sample::Delivery& delivery) {
    const auto appended = spool_->append(delivery.batch, delivery.contents);
    ASSERT_TRUE(appended) << appended.error().message;
  }
  std::vector<ContentHash> pending_hashes() const {
    std::vector<ContentHash> hashes;
    const auto pending = spool_->pending();
    EXPECT_TRUE(pending);
    for (const Batch& batch : *pending) hashes.push_back(hash(batch));
    return hashes;
  }

  std::shared_ptr<SpoolDisk> disk_ = std::make_shared<SpoolDisk>();
  TemporaryDirectory directory_;
  std::unique_ptr<Spool> spool_;
};

TEST_P(SpoolContract, PendingBatchesComeBackInOrderWithTheirContents) {
  sample::Run first(9, 1);
  sample::Run second(2, 2);
  std::vector<sample::Delivery> all;
  for (int round = 0; round < 3; ++round) {
    all.push_back(first.next(2));
    append(all.back());
    all.push_back(second.next(1));
    append(all.back());
  }
  restart();
  std::vector<ContentHash> expected;
  for (const auto& delivery : all) expected.push_back(hash(delivery.batch));
  EXPECT_EQ(pending_hashes(), expected);
  for (const auto& delivery : all) {
    for (const Bytes& bytes : delivery.contents) EXPECT_EQ(spool_->content(hash_bytes(bytes)).value(), bytes);
  }
}

TEST_P(SpoolContract, AcknowledgedBatchesAndTheirContentsAreForgotten) {
  sample::Run run(1, 1);
  sample::Run other(2, 2);
  const auto first = run.next(2);
  const auto second = run.next(2);
  const auto third = run.next(2);
  const auto foreign = other.next(1);
  for (const auto* delivery : {&first, &foreign, &second, &third}) append(*delivery);
  ASSERT_TRUE(spool_->acknowledged(run.experience(), 2));
  for (int opening = 0; opening < 2; ++opening, restart()) {
    EXPECT_EQ(pending_hashes(), (std::vector{hash(foreign.batch), hash(third.batch)}));
    const auto gone = spool_->content(hash_bytes(first.contents[0]));
    ASSERT_FALSE(gone);
    EXPECT_EQ(gone.error().code, ErrorCode::not_found);
    EXPECT_TRUE(spool_->content(hash_bytes(third.contents[0])));
  }
  ASSERT_TRUE(spool_->acknowledged(run.experience(), 1)) << "an old acknowledgement is harmless";
  ASSERT_TRUE(spool_->acknowledged({77}, 5)) << "and one of an unknown experience";
  EXPECT_EQ(pending_hashes().size(), 2U);
}

TEST_P(SpoolContract, SharedContentStaysWhileABatchNeedsIt) {
  sample::Run run(1, 1);
  const auto first = run.next(1);
  auto second = run.next(1);
  second.batch.places[0].content = first.batch.places[0].content;
  append(first);
  const auto appended = spool_->append(second.batch, {});
  ASSERT_TRUE(appended) << appended.error().message;
  ASSERT_TRUE(spool_->acknowledged(run.experience(), 1));
  restart();
  EXPECT_EQ(spool_->content(hash_bytes(first.contents[0])).value(), first.contents[0]);
}

TEST_P(SpoolContract, BatchWithoutItsContentIsRefused) {
  const auto delivery = sample::Run(1, 1).next(2);
  const auto appended = spool_->append(delivery.batch, {delivery.contents[0]});
  ASSERT_FALSE(appended);
  EXPECT_EQ(appended.error().code, ErrorCode::invalid);
  EXPECT_TRUE(pending_hashes().empty());
}

TEST_P(SpoolContract, RepeatIsHarmlessAndAnotherBatchOfTheSequenceIsRefused) {
  const auto delivery = sample::Run(1, 1).next(2);
  append(delivery);
  append(delivery);
  EXPECT_EQ(pending_hashes().size(), 1U);
  const auto altered = sample::Run(1, 99).next(2);
  const auto appended = spool_->append(altered.batch, altered.contents);
  ASSERT_FALSE(appended);
  EXPECT_EQ(appended.error().code, ErrorCode::conflict);
}

TEST_P(SpoolContract, GoesOnAfterEverythingWasAcknowledgedAndReopened) {
  sample::Run run(1, 1);
  append(run.next(1));
  ASSERT_TRUE(spool_->acknowledged(run.experience(), 1));
  restart();
  EXPECT_TRUE(pending_hashes().empty());
  append(run.next(1));
  restart();
  EXPECT_EQ(pending_hashes().size(), 1U);
}

TEST_P(SpoolContract, WhyTheRobotStandsComesBackUntilThatIsOver) {
  EXPECT_EQ(spool_->stops(), Stops{});
  for (const Stops& stops : {Stops{true, false}, Stops{true, true}, Stops{false, true}, Stops{}}) {
    ASSERT_TRUE(spool_->keep(stops));
    EXPECT_EQ(spool_->stops(), stops);
    restart();
    EXPECT_EQ(spool_->stops(), stops);
  }
}

/// Returns the run's delivery as it is after it was refined: another content for the first place.
sample::Delivery refined(const sample::Delivery& delivery) {
  sample::Delivery better = delivery;
  better.contents[0].push_back(7);
  better.batch.places[0].content.hash = hash_bytes(better.contents[0]);
  return better;
}

TEST_P(SpoolContract, ARunIsReplacedAsAWhole) {
  sample::Run run(1, 1);
  sample::Run other(2, 2);
  const auto first = run.next(2);
  const auto foreign = other.next(1);
  const auto second = run.next(2);
  for (const auto* delivery : {&first, &foreign, &second}) append(*delivery);
  const auto better = refined(first);
  const auto replaced = spool_->replace(run.experience(), {better.batch, second.batch}, {better.contents[0]});
  ASSERT_TRUE(replaced) << replaced.error().message;
  for (int opening = 0; opening < 2; ++opening, restart()) {
    EXPECT_EQ(pending_hashes(), (std::vector{hash(foreign.batch), hash(better.batch), hash(second.batch)}));
    EXPECT_EQ(spool_->content(hash_bytes(better.contents[0])).value(), better.contents[0]);
    EXPECT_EQ(spool_->content(hash_bytes(first.contents[1])).value(), first.contents[1]) << "still needed";
    EXPECT_FALSE(spool_->content(hash_bytes(first.contents[0]))) << "what it replaced is gone";
  }
  ASSERT_TRUE(spool_->acknowledged(run.experience(), 2));
  EXPECT_EQ(pending_hashes(), std::vector{hash(foreign.batch)});
}

TEST_P(SpoolContract, AReplacementThatIsRefusedChangesNothing) {
  sample::Run run(1, 1);
  const auto first = run.next(2);
  append(first);
  const auto better = refined(first);
  const auto foreign = sample::Run(2, 2).next(1);
  const auto expect = [&](ErrorCode code, ExperienceId of, const std::vector<Batch>& batches,
                          const std::vector<Bytes>& contents) {
    const auto replaced = spool_->replace(of, batches, contents);
    ASSERT_FALSE(replaced);
    EXPECT_EQ(replaced.error().code, code) << replaced.error().message;
    EXPECT_EQ(pending_hashes(), std::vector{hash(first.batch)});
  };
  expect(ErrorCode::invalid, run.experience(), {}, {});
  expect(ErrorCode::invalid, run.experience(), {better.batch}, {});
  expect(ErrorCode::invalid, run.experience(), {better.batch, better.batch}, better.contents);
  expect(ErrorCode::invalid, run.experience(), {foreign.batch}, foreign.contents);
  expect(ErrorCode::not_found, {77}, {better.batch}, better.contents);
}

TEST_P(SpoolContract, ATrialOfRoomLeavesNothing) {
  sample::Run run(9, 1);
  append(run.next(2));
  const std::vector<ContentHash> before = pending_hashes();
  const auto tried = spool_->try_room(100'000);
  ASSERT_TRUE(tried) << tried.error().message;
  if (GetParam() == Kind::file) {
    for (const auto& entry : std::filesystem::directory_iterator(directory_.path() / "spool")) {
      EXPECT_LT(entry.file_size(), 100'000U) << entry.path();
    }
  }
  restart();
  EXPECT_EQ(pending_hashes(), before);
  EXPECT_TRUE(spool_->skipped().empty());
}

INSTANTIATE_TEST_SUITE_P(Spools, SpoolContract, testing::Values(Kind::memory, Kind::file),
                         [](const auto& instance) { return instance.param == Kind::memory ? "memory" : "file"; });

}  // namespace
}  // namespace weft::storage
