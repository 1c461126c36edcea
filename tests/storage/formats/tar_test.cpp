#include "storage/formats/tar.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <string>
#include <string_view>

#include "core/text.hpp"
#include "storage/formats/gzip.hpp"

namespace weft::formats {
namespace {
using namespace std::chrono_literals;

/// Reads a field of the record that begins there, up to its zero byte.
std::string field_of(const Bytes& archive, std::size_t record, std::size_t at, std::size_t size) {
  const std::string_view all = text_in(archive);
  const std::string_view field = all.substr(record + at, size);
  return std::string(field.substr(0, field.find('\0')));
}

TEST(Tar, HasEachFileInRecordsWithItsChecksum) {
  const auto archive = tar_of({{"a/b.txt", "hello"}, {"empty", ""}, {"full", std::string(512, 'x')}}, WallTime(8s));
  ASSERT_TRUE(archive) << archive.error().message;
  ASSERT_EQ(archive->size(), 512U * (2 + 1 + 2 + 2));
  EXPECT_EQ(field_of(*archive, 0, 0, 100), "a/b.txt");
  EXPECT_EQ(field_of(*archive, 0, 100, 8), "0000644");
  EXPECT_EQ(field_of(*archive, 0, 124, 12), "00000000005");
  EXPECT_EQ(field_of(*archive, 0, 136, 12), "00000000010");
  EXPECT_EQ(field_of(*archive, 0, 257, 6), "ustar");
  EXPECT_EQ(text_in(*archive).substr(512, 6), std::string_view("hello\0", 6));
  EXPECT_EQ(field_of(*archive, 1024, 0, 100), "empty");
  EXPECT_EQ(field_of(*archive, 1536, 124, 12), "00000001000");
  std::uint64_t sum = 0;
  for (std::size_t i = 0; i < 512; ++i) sum += i >= 148 && i < 156 ? ' ' : (*archive)[i];
  EXPECT_EQ(std::stoull(field_of(*archive, 0, 148, 8), nullptr, 8), sum);
}

TEST(Tar, RefusesNamesThatDoNotFit) {
  EXPECT_TRUE(tar_of({{std::string(100, 'n'), "x"}}, {}));
  const auto longer = tar_of({{std::string(101, 'n'), "x"}}, {});
  ASSERT_FALSE(longer);
  EXPECT_NE(longer.error().message.find("101 bytes"), std::string::npos) << longer.error().message;
  EXPECT_FALSE(tar_of({{"", "x"}}, {}));
}

TEST(Gzip, UnpacksToWhatWasPacked) {
  for (const std::size_t size : {std::size_t{0}, std::size_t{1}, std::size_t{1'000'000}}) {
    Bytes bytes(size);
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<std::uint8_t>(i * i % 251);
    const auto packed = gzip(bytes);
    ASSERT_TRUE(packed);
    EXPECT_TRUE(is_gzip(*packed));
    const auto unpacked = gunzip(*packed, size);
    ASSERT_TRUE(unpacked) << unpacked.error().message;
    EXPECT_EQ(*unpacked, bytes);
  }
}

}  // namespace
}  // namespace weft::formats
