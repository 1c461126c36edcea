#include "agents/methods/ceiling/content.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/random.hpp"
#include "tests/agents/methods/ceiling/rendered_ceiling.hpp"

namespace weft::agents {
namespace {

CeilingContent content_of(std::size_t features) {
  CeilingContent content;
  content.camera = test::up_camera(0.02, 0.01);
  content.attitude = {0.001, -0.002, 0.0005};
  content.attitude_sigma = {0.001, 0.001, 0.001};
  content.ceiling_m = 6.4;
  content.ceiling_sigma_m = 0.05;
  Random random(3);
  for (std::size_t i = 0; i < features; ++i) {
    PlaneFeature f;
    f.on_plane = {random.uniform(-7.0, 7.0), random.uniform(-7.0, 7.0)};
    f.heading_rad = random.uniform(-3.1, 3.1);
    f.above_floor_m = random.uniform(4.0, 6.4);
    f.above_floor_sigma_m = random.uniform(0.0, 0.8);
    for (std::uint64_t& word : f.descriptor) word = random.next();
    content.features.push_back(f);
  }
  content.patch = {3, 2, 0.05, {0.05, 0.1}, {1, 2, 3, 4, 5, 6}};
  return content;
}

TEST(CeilingContentBytes, RoundTrip) {
  const CeilingContent before = content_of(50);
  const Bytes bytes = encode_ceiling_content(before);
  const auto after = decode_ceiling_content(bytes);
  ASSERT_TRUE(after) << after.error().message;
  EXPECT_EQ(encode_ceiling_content(*after), bytes) << "canonical: the bytes of what was read are the bytes";
  ASSERT_EQ(after->features.size(), 50U);
  for (std::size_t i = 0; i < 50; ++i) {
    EXPECT_LT((after->features[i].on_plane - before.features[i].on_plane).norm(), 1e-3);
    EXPECT_NEAR(after->features[i].above_floor_m, before.features[i].above_floor_m, 6e-4);
    EXPECT_NEAR(after->features[i].above_floor_sigma_m, before.features[i].above_floor_sigma_m, 6e-4);
    EXPECT_EQ(after->features[i].descriptor, before.features[i].descriptor);
  }
  EXPECT_EQ(after->ceiling_m, 6.4);
  EXPECT_EQ(after->patch.pixels, before.patch.pixels);
}

TEST(CeilingContentBytes, TheLargestFitsItsBound) {
  CeilingContent content = content_of(most_ceiling_features);
  content.camera.id = std::string(64, 'x');
  content.camera.lens = LensModel::rational;
  content.patch.width = content.patch.height = widest_ceiling_patch_px;
  content.patch.pixels.assign(static_cast<std::size_t>(widest_ceiling_patch_px * widest_ceiling_patch_px), 7);
  const Bytes bytes = encode_ceiling_content(content);
  EXPECT_LE(bytes.size(), largest_ceiling_content);
  EXPECT_TRUE(decode_ceiling_content(bytes));
}

TEST(CeilingContentBytes, LayoutIsTheDocumented) {
  const Bytes bytes = encode_ceiling_content(content_of(2));
  EXPECT_EQ((Bytes(bytes.begin(), bytes.begin() + 8)), (Bytes{'W', 'L', 'C', 'L', 1, 0, 0, 0}));
  EXPECT_EQ(bytes.size(), 8 + (1 + 2 + 4 + 16 * 8) + 8 * 8 + (2 + 2 * 41) + (4 + 3 * 8 + 6));
}

TEST(CeilingContentBytes, EveryTruncationAndTrailingBytesAreCorrupt) {
  Bytes bytes = encode_ceiling_content(content_of(3));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const auto cut = decode_ceiling_content(ByteView(bytes.data(), size));
    ASSERT_FALSE(cut);
    EXPECT_EQ(cut.error().code, ErrorCode::corrupt);
  }
  bytes.push_back(0);
  EXPECT_THAT(decode_ceiling_content(bytes).error().message, testing::HasSubstr("end"));
}

TEST(CeilingContentBytes, WhatCannotBeIsNamed) {
  CeilingContent low = content_of(1);
  low.features[0].above_floor_m = 0.4;
  EXPECT_THAT(decode_ceiling_content(encode_ceiling_content(low)).error().message,
              testing::HasSubstr("feature.height"));
  CeilingContent sunk = content_of(1);
  sunk.ceiling_m = 0.5;
  EXPECT_THAT(decode_ceiling_content(encode_ceiling_content(sunk)).error().message, testing::HasSubstr("ceiling at"));
  EXPECT_THAT(decode_ceiling_content(encode_ceiling_content(content_of(301))).error().message,
              testing::HasSubstr("features.count"));
  Bytes large(20000, 0);
  const Bytes begin = encode_ceiling_content(content_of(1));
  std::copy(begin.begin(), begin.end(), large.begin());
  EXPECT_THAT(decode_ceiling_content(large).error().message, testing::HasSubstr("16384"));
  Bytes newer = begin;
  newer[4] = 2;
  EXPECT_EQ(decode_ceiling_content(newer).error().code, ErrorCode::newer);
}

}  // namespace
}  // namespace weft::agents
