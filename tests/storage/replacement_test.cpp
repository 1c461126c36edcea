#include "storage/spool/replacement.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <map>
#include <set>

#include "core/network/codec.hpp"
#include "storage/spool/durable_file.hpp"
#include "storage/spool/file_spool.hpp"
#include "tests/storage/killed_child.hpp"
#include "tests/storage/sample_map.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::storage {
namespace {

/// Arranges a run of two batches and its refined form, and knows the files of both.
class ReplacementSteps : public testing::Test {
 protected:
  void SetUp() override {
    sample::Run run(1, 1);
    for (int batch = 0; batch < 2; ++batch) {
      drafts_.push_back(run.next(1, 40));
      refined_.push_back(drafts_.back());
      refined_.back().contents[0].push_back(7);
      refined_.back().batch.places[0].content.hash = hash_bytes(refined_.back().contents[0]);
    }
    const TemporaryDirectory made;
    auto spool = open_file_spool(made.path());
    ASSERT_TRUE(spool);
    for (const auto& draft : drafts_) ASSERT_TRUE((*spool)->append(draft.batch, draft.contents));
    for (const std::uint64_t order : {1U, 2U}) files_[order] = read_whole(batch(made.path(), order)).value();
    ASSERT_TRUE(replace(**spool));
    for (const std::uint64_t order : {3U, 4U}) files_[order] = read_whole(batch(made.path(), order)).value();
    EXPECT_FALSE(std::filesystem::exists(made.path() / kReplacementFile));
  }

  static std::filesystem::path batch(const std::filesystem::path& directory, std::uint64_t order) {
    return directory / numbered(order, kBatchEnding);
  }
  Result<void> replace(Spool& spool) const {
    return spool.replace({1}, {refined_[0].batch, refined_[1].batch},
                         {refined_[0].contents[0], refined_[1].contents[0]});
  }
  static std::vector<ContentHash> hashes(const std::vector<sample::Delivery>& deliveries) {
    std::vector<ContentHash> all;
    for (const auto& delivery : deliveries) all.push_back(hash(delivery.batch));
    return all;
  }
  static std::vector<ContentHash> pending(const std::filesystem::path& directory) {
    auto spool = open_file_spool(directory);
    EXPECT_TRUE(spool) << spool.error().message;
    std::vector<ContentHash> all;
    const Result<std::vector<Batch>> batches = (*spool)->pending();
    for (const Batch& batch : *batches) all.push_back(hash(batch));
    EXPECT_TRUE((*spool)->skipped().empty());
    return all;
  }

  /// Opens a spool that was interrupted with these files there.
  std::vector<ContentHash> left_with(const std::set<std::uint64_t>& named, const std::set<std::uint64_t>& staged,
                                     bool is_decided) const {
    const TemporaryDirectory left;
    for (const std::uint64_t order : named) EXPECT_TRUE(write_durably(batch(left.path(), order), files_.at(order)));
    for (const std::uint64_t order : staged)
      EXPECT_TRUE(write_durably(left.path() / numbered(order, kStagedEnding), files_.at(order)));
    if (is_decided) {
      EXPECT_TRUE(write_durably(left.path() / kReplacementFile, encode(Replacement{{1, 2}, {3, 4}})));
    }
    const std::vector<ContentHash> found = pending(left.path());
    EXPECT_EQ(pending(left.path()), found) << "opened twice";
    const std::filesystem::directory_iterator files(left.path());
    EXPECT_EQ(std::distance(begin(files), end(files)), 2) << "nothing else is left";
    return found;
  }

  std::vector<sample::Delivery> drafts_;
  std::vector<sample::Delivery> refined_;
  std::map<std::uint64_t, Bytes> files_;
};

TEST_F(ReplacementSteps, InterruptedBeforeItIsDecidedTheDraftIsThere) {
  EXPECT_EQ(left_with({1, 2}, {}, false), hashes(drafts_));
  EXPECT_EQ(left_with({1, 2}, {3}, false), hashes(drafts_));
  EXPECT_EQ(left_with({1, 2}, {3, 4}, false), hashes(drafts_));
}

TEST_F(ReplacementSteps, InterruptedOnceItIsDecidedTheRefinedRunIsThere) {
  EXPECT_EQ(left_with({1, 2}, {3, 4}, true), hashes(refined_));
  EXPECT_EQ(left_with({1, 2, 3}, {4}, true), hashes(refined_));
  EXPECT_EQ(left_with({1, 2, 3, 4}, {}, true), hashes(refined_));
  EXPECT_EQ(left_with({2, 3, 4}, {}, true), hashes(refined_));
  EXPECT_EQ(left_with({3, 4}, {}, true), hashes(refined_));
}

TEST_F(ReplacementSteps, KilledAtAnyMomentOneOfBothIsThereAsAWhole) {
  for (unsigned after = 0; after < 40; ++after) {
    const TemporaryDirectory directory;
    {
      auto spool = open_file_spool(directory.path());
      ASSERT_TRUE(spool);
      for (const auto& draft : drafts_) ASSERT_TRUE((*spool)->append(draft.batch, draft.contents));
    }
    constexpr unsigned step_us = 150;
    run_and_kill(1, after * step_us, [&](const auto& report) {
      auto spool = open_file_spool(directory.path());
      report(1);
      if (spool) (void)replace(**spool);
    });
    const std::vector<ContentHash> found = pending(directory.path());
    EXPECT_TRUE(found == hashes(drafts_) || found == hashes(refined_)) << after;
  }
}

TEST_F(ReplacementSteps, WhatTheDiskDoesNotCarryOutIsReadAllTheSame) {
  const TemporaryDirectory directory;
  auto spool = open_file_spool(directory.path());
  ASSERT_TRUE(spool);
  for (const auto& draft : drafts_) ASSERT_TRUE((*spool)->append(draft.batch, draft.contents));
  const std::filesystem::path in_the_way = batch(directory.path(), 3);
  std::filesystem::create_directory(in_the_way);
  EXPECT_EQ(replace(**spool).error().code, ErrorCode::unavailable);
  for (const auto& refined : refined_) {
    for (const Bytes& content : refined.contents) {
      const Result<Bytes> read = (*spool)->content(hash_bytes(content));
      ASSERT_TRUE(read) << read.error().message;
      EXPECT_EQ(*read, content);
    }
  }
  std::filesystem::remove(in_the_way);
  EXPECT_EQ(pending(directory.path()), hashes(refined_));
}

TEST_F(ReplacementSteps, ADamagedDecisionIsNamed) {
  for (const std::string_view text : {"", "weft-replace 1\n", "weft-replace 1\nremove 1\nend\n",
                                      "weft-replace 1\nadd 0000000000000003\nremove 0000000000000001\nend\n"}) {
    const TemporaryDirectory directory;
    ASSERT_TRUE(write_durably(directory.path() / kReplacementFile, Bytes(text.begin(), text.end())));
    const auto spool = open_file_spool(directory.path());
    ASSERT_FALSE(spool) << text;
    EXPECT_EQ(spool.error().code, ErrorCode::corrupt);
    EXPECT_NE(spool.error().message.find((directory.path() / kReplacementFile).string()), std::string::npos);
  }
  const TemporaryDirectory directory;
  const std::string_view later = "weft-replace 2\nend\n";
  ASSERT_TRUE(write_durably(directory.path() / kReplacementFile, Bytes(later.begin(), later.end())));
  EXPECT_EQ(open_file_spool(directory.path()).error().code, ErrorCode::newer);
}

TEST(Replacement, ComesBackAsItWasWritten) {
  const Replacement some{{1, 0x123456789abcdefULL}, {7}};
  const auto read = decode_replacement(encode(some));
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(read->removed, some.removed);
  EXPECT_EQ(read->added, some.added);
}

}  // namespace
}  // namespace weft::storage
