#include "storage/spool/file_spool.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>
#include <fstream>

#include "core/network/codec.hpp"
#include "storage/spool/durable_file.hpp"
#include "tests/storage/sample_map.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::storage {
namespace {

std::vector<std::filesystem::path> files_in(const std::filesystem::path& directory) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

void write_plainly(const std::filesystem::path& file, ByteView bytes) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
}

/// Arranges a spool of two batches, the second of which a test damages.
class FileSpoolDamage : public testing::Test {
 protected:
  void SetUp() override {
    sample::Run run(1, 1);
    auto spool = open_file_spool(directory_.path());
    ASSERT_TRUE(spool) << spool.error().message;
    for (int batch = 0; batch < 2; ++batch) {
      const auto delivery = run.next(1, 40);
      ASSERT_TRUE((*spool)->append(delivery.batch, delivery.contents));
    }
    last_ = files_in(directory_.path()).back();
    bytes_ = read_whole(last_).value();
  }
  /// Opens the spool; the first batch must be there, the last one skipped and named.
  void expect_last_is_skipped(const std::string& how) const {
    const auto spool = open_file_spool(directory_.path());
    ASSERT_TRUE(spool) << how << ": " << spool.error().message;
    const auto pending = (*spool)->pending();
    ASSERT_EQ(pending->size(), 1U) << how;
    EXPECT_EQ(pending->front().sequence, 1U) << how;
    ASSERT_EQ((*spool)->skipped().size(), 1U) << how;
    EXPECT_NE((*spool)->skipped().front().find(last_.string()), std::string::npos) << how;
  }

  TemporaryDirectory directory_;
  std::filesystem::path last_;
  Bytes bytes_;
};

TEST_F(FileSpoolDamage, TailTornAtAnyByteIsSkippedAndNamed) {
  for (std::size_t size = 0; size < bytes_.size(); ++size) {
    write_plainly(last_, ByteView(bytes_).first(size));
    expect_last_is_skipped("torn after " + std::to_string(size) + " bytes");
  }
}

TEST_F(FileSpoolDamage, AnyFlippedBitIsNoticed) {
  for (std::size_t at = 0; at < bytes_.size(); ++at) {
    if (at == 7) continue;  // the version: the test below
    Bytes damaged = bytes_;
    damaged[at] ^= static_cast<std::uint8_t>(1U << (at % 8));
    write_plainly(last_, damaged);
    expect_last_is_skipped("flipped at byte " + std::to_string(at));
  }
}

TEST_F(FileSpoolDamage, TrailingBytesAreNoticed) {
  Bytes longer = bytes_;
  longer.push_back(0);
  write_plainly(last_, longer);
  expect_last_is_skipped("one byte more");
}

TEST_F(FileSpoolDamage, NewerFormatIsRefusedNotSkipped) {
  bytes_[7] = 9;
  write_plainly(last_, bytes_);
  const auto spool = open_file_spool(directory_.path());
  ASSERT_FALSE(spool);
  EXPECT_EQ(spool.error().code, ErrorCode::newer);
  EXPECT_NE(spool.error().message.find("format 9"), std::string::npos) << spool.error().message;
  EXPECT_NE(spool.error().message.find("format 1"), std::string::npos) << spool.error().message;
}

TEST_F(FileSpoolDamage, DamageAfterOpeningIsCorruptAtReading) {
  const auto spool = open_file_spool(directory_.path());
  ASSERT_TRUE(spool);
  const ContentHash hash = (*spool)->pending()->back().places.front().content.hash;
  ASSERT_TRUE((*spool)->content(hash));
  bytes_.back() ^= 1U;
  write_plainly(last_, bytes_);
  const auto read = (*spool)->content(hash);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::corrupt);
}

TEST_F(FileSpoolDamage, SkippedFileIsNotOverwritten) {
  write_plainly(last_, ByteView(bytes_).first(20));
  sample::Run run(1, 1);
  auto spool = open_file_spool(directory_.path());
  (void)run.next(1, 40);
  const auto again = run.next(1, 40);
  ASSERT_TRUE((*spool)->append(again.batch, again.contents));
  EXPECT_EQ(read_whole(last_)->size(), 20U);
  EXPECT_EQ((*open_file_spool(directory_.path()))->pending()->size(), 2U);
}

TEST_F(FileSpoolDamage, LeftoverOfAnInterruptedAppendIsRemoved) {
  write_plainly(directory_.path() / "0000000000000003.batch.tmp", bytes_);
  EXPECT_EQ((*open_file_spool(directory_.path()))->pending()->size(), 2U);
  EXPECT_EQ(files_in(directory_.path()).size(), 2U);
}

/// Keeps files of this process from growing beyond `bytes` while it lives: the disk seems full.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FileSizeLimit() { ::setrlimit(RLIMIT_FSIZE, &before_); }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;

 private:
  rlimit before_{};
};

TEST_F(FileSpoolDamage, FullDiskIsExhaustedAndLeavesNothing) {
  auto spool = open_file_spool(directory_.path());
  sample::Run run(2, 2);
  const auto delivery = run.next(1, 100'000);
  {
    const FileSizeLimit limit(4096);
    const auto appended = (*spool)->append(delivery.batch, delivery.contents);
    ASSERT_FALSE(appended);
    EXPECT_EQ(appended.error().code, ErrorCode::exhausted) << appended.error().message;
  }
  EXPECT_EQ(files_in(directory_.path()).size(), 2U);
  EXPECT_EQ((*spool)->pending()->size(), 2U);
  ASSERT_TRUE((*spool)->append(delivery.batch, delivery.contents)) << "goes on when there is space again";
  EXPECT_EQ((*open_file_spool(directory_.path()))->pending()->size(), 3U);
}

TEST(FileSpool, WhereItIsNotKnownWhyTheRobotStandsAPersonHasToLook) {
  const TemporaryDirectory directory;
  const Stops both{.by_operator = true, .by_emergency_stop = true};
  for (const std::string_view text : {"", "weft-stops 1\n", "weft-stops 1\noperator\n", "weft-stops 2\nend\n",
                                      "weft-stops 1\nlightning\nend\n", "weft-stops 1\nend\nend\n", "\xff\xfe"}) {
    std::ofstream(directory.path() / "stops", std::ios::binary) << text;
    auto spool = open_file_spool(directory.path());
    ASSERT_TRUE(spool) << spool.error().message;
    EXPECT_EQ((*spool)->stops(), both) << text;
    ASSERT_EQ((*spool)->skipped().size(), 1U);
    EXPECT_NE((*spool)->skipped().front().find((directory.path() / "stops").string()), std::string::npos);
    ASSERT_TRUE((*spool)->keep(both)) << "the same again mends the file";
    spool = open_file_spool(directory.path());
    ASSERT_TRUE(spool);
    EXPECT_EQ((*spool)->stops(), both);
    EXPECT_TRUE((*spool)->skipped().empty());
    ASSERT_TRUE((*spool)->keep(Stops{}));
    EXPECT_FALSE(std::filesystem::exists(directory.path() / "stops"));
  }
}

TEST(FileSpool, UnusableDirectoryIsUnavailable) {
  const TemporaryDirectory directory;
  std::ofstream(directory.path() / "file") << "no directory";
  const auto spool = open_file_spool(directory.path() / "file" / "below");
  ASSERT_FALSE(spool);
  EXPECT_EQ(spool.error().code, ErrorCode::unavailable);
}

TEST(FileSpool, TellsWhatItsDiskHasLeft) {
  const TemporaryDirectory directory;
  auto spool = open_file_spool(directory.path());
  ASSERT_TRUE(spool) << spool.error().message;
  EXPECT_GT((*spool)->free_bytes().value_or(0), 0U);
  const std::filesystem::path aside = directory.path().string() + ".aside";
  std::filesystem::rename(directory.path(), aside);
  EXPECT_EQ((*spool)->free_bytes(), std::nullopt);
  std::filesystem::rename(aside, directory.path());
}

}  // namespace
}  // namespace weft::storage
