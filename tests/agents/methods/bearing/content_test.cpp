#include "agents/methods/bearing/content.hpp"

#include <gmock/gmock.h>

namespace weft::agents {
namespace {

using testing::HasSubstr;

BearingContent some_content() {
  BearingContent content;
  content.focal_px = 386.5;
  content.driving = {0.6, -0.2};
  for (int i = 0; i < 30; ++i)
    content.features.push_back({{-100.25F + 7.0F * static_cast<float>(i), 3.125F * static_cast<float>(i)},
                                {static_cast<std::uint64_t>(i), 2U, 3U, ~0ULL}});
  return content;
}

TEST(BearingContent, ComesBackAsItWas) {
  const BearingContent content = some_content();
  const auto again = decode_bearing_content(encode_bearing_content(content));
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->focal_px, content.focal_px);
  EXPECT_EQ(again->driving, content.driving);
  ASSERT_EQ(again->features.size(), content.features.size());
  for (std::size_t i = 0; i < content.features.size(); ++i) {
    EXPECT_EQ(again->features[i].pixel, content.features[i].pixel) << "eighths of a pixel are kept";
    EXPECT_EQ(again->features[i].descriptor, content.features[i].descriptor);
  }
}

TEST(BearingContent, EveryCutIsNamed) {
  const Bytes bytes = encode_bearing_content(some_content());
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    const auto cut = decode_bearing_content(ByteView(bytes).first(size));
    ASSERT_FALSE(cut) << size;
    EXPECT_EQ(cut.error().code, ErrorCode::corrupt);
    EXPECT_THAT(cut.error().message, HasSubstr("bearing content: "));
  }
}

TEST(BearingContent, WhatIsImpossibleIsRefused) {
  const Bytes good = encode_bearing_content(some_content());
  Bytes bytes = good;
  bytes.push_back(0);
  EXPECT_THAT(decode_bearing_content(bytes).error().message, HasSubstr("followed by more bytes"));
  bytes = good;
  bytes[0] ^= 1U;
  EXPECT_THAT(decode_bearing_content(bytes).error().message, HasSubstr("magic"));
  bytes = good;
  bytes[4] = 5;
  EXPECT_EQ(decode_bearing_content(bytes).error().code, ErrorCode::newer);
  BearingContent content = some_content();
  content.focal_px = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(decode_bearing_content(encode_bearing_content(content)).error().message, HasSubstr("focal_px"));
}

TEST(BearingContent, WhatWasNeverLearnedIsReadByEveryRobot) {
  const Bytes bytes = encode_bearing_content(some_content());
  EXPECT_EQ(bytes[4], 1);
  EXPECT_EQ(bytes.size(), 34U + 30U * 36U);
  EXPECT_TRUE(decode_bearing_content(bytes)->sightings.empty());
}

BearingContent learned_content() {
  BearingContent content = some_content();
  for (std::uint8_t i = 0; i < 30; ++i) content.sightings.push_back({static_cast<std::uint8_t>(i + 1), i});
  return content;
}

TEST(BearingContent, SightingsComeBackAsTheyWere) {
  const BearingContent content = learned_content();
  const Bytes bytes = encode_bearing_content(content);
  EXPECT_EQ(bytes[4], 2);
  EXPECT_EQ(bytes.size(), 34U + 30U * 38U);
  const auto again = decode_bearing_content(bytes);
  ASSERT_TRUE(again) << again.error().message;
  EXPECT_EQ(again->sightings, content.sightings);
  ASSERT_EQ(again->features.size(), content.features.size());
  EXPECT_EQ(again->features.back().pixel, content.features.back().pixel);
  EXPECT_EQ(encode_bearing_content(*again), bytes);
  for (std::size_t size = 0; size < bytes.size(); size += 7)
    EXPECT_FALSE(decode_bearing_content(ByteView(bytes).first(size))) << size;
}

TEST(BearingContent, SaysHowItsFeaturesAreDescribed) {
  for (BearingContent content : {some_content(), learned_content()}) {
    EXPECT_EQ(decode_bearing_content(encode_bearing_content(content))->description, Description::gradients);
    content.description = Description::brief;
    const Bytes bytes = encode_bearing_content(content);
    const auto again = decode_bearing_content(bytes);
    ASSERT_TRUE(again) << again.error().message;
    EXPECT_EQ(again->description, Description::brief);
    EXPECT_EQ(again->sightings, content.sightings);
    EXPECT_EQ(encode_bearing_content(*again), bytes);
  }
}

TEST(BearingContent, SightingsThatCannotBeAreRefused) {
  BearingContent content = learned_content();
  content.sightings[3] = {2, 3};
  EXPECT_THAT(decode_bearing_content(encode_bearing_content(content)).error().message, HasSubstr("feature.seen"));
  content.sightings[3] = {0, 0};
  EXPECT_THAT(decode_bearing_content(encode_bearing_content(content)).error().message, HasSubstr("feature.could"));
  Bytes bytes = encode_bearing_content(some_content());
  bytes[4] = 2;
  EXPECT_FALSE(decode_bearing_content(bytes)) << "it has none";
}

}  // namespace
}  // namespace weft::agents
