#include <gmock/gmock.h>

#include "storage/clouds/cloud.hpp"
#include "tests/storage/clouds/sample_clouds.hpp"

namespace weft::clouds {
namespace {

TEST(CompressCloud, TheSameBytesComeBack) {
  for (const std::size_t count : {0U, 1U, 2U, 1000U, 70'000U}) {
    for (const std::uint64_t values_below : {0U, 200U, 50'000U}) {
      const Bytes canonical = canonical_bytes(sample::room(count, count, values_below), kFineQuantum_um).value();
      const auto compressed = compress_cloud(canonical);
      ASSERT_TRUE(compressed) << compressed.error().message;
      const auto expanded = expand_cloud(*compressed);
      ASSERT_TRUE(expanded) << expanded.error().message;
      EXPECT_EQ(*expanded, canonical);
    }
  }
}

TEST(CompressCloud, TheSameBytesComeBackWithWhatIsAttached) {
  for (const std::size_t count : {0U, 1U, 1000U}) {
    for (const std::uint64_t values_below : {0U, 200U, 50'000U}) {
      for (const std::size_t attached : {1U, 14'000U}) {
        const Cloud cloud = sample::with_attachment(sample::room(count, count, values_below), 8, attached);
        const Bytes canonical = canonical_bytes(cloud, 5000).value();
        const Bytes compressed = compress_cloud(canonical).value();
        EXPECT_EQ(expanded_size(compressed).value(), canonical.size());
        EXPECT_EQ(expand_cloud(compressed).value(), canonical);
      }
    }
  }
}

TEST(CompressCloud, WhatIsAttachedIsCompressedToo) {
  const Cloud plain = sample::room(6, 2000, 0);
  Cloud cloud = plain;
  cloud.attached = Bytes(100'000, 7);
  const std::size_t alone = compress_cloud(canonical_bytes(plain, 2000).value())->size();
  EXPECT_LT(compress_cloud(canonical_bytes(cloud, 2000).value())->size(), alone + 100);
}

TEST(CompressCloud, ManyEqualPointsTakeNextToNothing) {
  const Cloud cloud = sample::of_points(std::vector<Eigen::Vector3f>(100'000, Eigen::Vector3f(1, 2, 3)));
  EXPECT_LT(compress_cloud(canonical_bytes(cloud, kFineQuantum_um).value())->size(), 200U);
}

TEST(CompressCloud, ARoomIsFiveTimesSmallerThanItsFloats) {
  const Cloud cloud = sample::room(6, 200'000, 0);
  const Bytes compressed = compress_cloud(canonical_bytes(cloud, 2000).value()).value();
  EXPECT_LT(compressed.size() * 5, cloud.points.size() * 12);
}

TEST(CompressCloud, AnotherFormatIsNamedAsSuch) {
  Bytes canonical = canonical_bytes(sample::room(1, 10, 0), 1000).value();
  Bytes compressed = compress_cloud(canonical).value();
  Bytes before = canonical;
  before[7] = 1;
  EXPECT_EQ(decode_cloud(before).error().code, ErrorCode::corrupt);
  EXPECT_THAT(decode_cloud(before).error().message, testing::HasSubstr("format 1, this software reads format 2"));
  compressed[7] = 3;
  EXPECT_EQ(expand_cloud(compressed).error().code, ErrorCode::newer);
  canonical[7] = 3;
  EXPECT_EQ(compress_cloud(canonical).error().code, ErrorCode::newer);
  EXPECT_EQ(decode_cloud(canonical).error().code, ErrorCode::newer);
}

TEST(CompressCloud, DamageIsNamedAsSuch) {
  Bytes compressed = compress_cloud(canonical_bytes(sample::room(1, 100, 0), 1000).value()).value();
  compressed.back() ^= 1U;
  const auto damaged = expand_cloud(compressed);
  ASSERT_FALSE(damaged);
  EXPECT_EQ(damaged.error().code, ErrorCode::corrupt);
  EXPECT_THAT(damaged.error().message, testing::HasSubstr("SHA-256"));
}

}  // namespace
}  // namespace weft::clouds
