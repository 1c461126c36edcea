#include "images/png.hpp"

#include <gmock/gmock.h>

#include "tests/support/raw_png.hpp"

namespace weft::images {
namespace {

using test::RawPng;
using testing::HasSubstr;

Bytes grey_of(const RawPng& png) {
  const auto picture = decode_png(test::png_bytes(png), "a.png", Shades::grey);
  EXPECT_TRUE(picture) << picture.error().message;
  return picture ? picture->samples : Bytes{};
}

TEST(PngPicture, GreyIsTakenAsItIs) {
  const auto picture = decode_png(test::png_bytes(RawPng{.width = 2, .height = 2, .rows = {0, 0, 1, 0, 205, 255}}),
                                  "a.png", Shades::grey);
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(*picture, (Picture{Shades::grey, 2, 2, {0, 1, 205, 255}}));
}

// The greys that OpenCV 4.6 reads from the same files.
TEST(PngPicture, ColoursBecomeTheGreyOfTheirWeights) {
  const Bytes row = {0, 255, 255, 255, 10, 20, 33, 200, 3, 99, 0, 0, 255};
  EXPECT_EQ(grey_of({.width = 4, .height = 1, .kind = 2, .rows = row}), (Bytes{255, 18, 72, 29}));
  EXPECT_EQ(grey_of({.width = 2, .height = 1, .kind = 6, .rows = {0, 10, 20, 33, 0, 200, 3, 99, 128}}),
            (Bytes{18, 72}))
      << "opacity is left out";
  EXPECT_EQ(grey_of({.width = 3,
                     .height = 1,
                     .bits = 4,
                     .kind = 3,
                     .rows = {0, 0x10, 0x20},
                     .parts = {{"PLTE", {10, 20, 33, 200, 3, 99, 0, 0, 255}}}}),
            (Bytes{72, 18, 29}))
      << "a palette";
}

TEST(PngPicture, OtherDepthsBecomeEightBits) {
  EXPECT_EQ(grey_of({.width = 2, .height = 1, .bits = 16, .rows = {0, 0x12, 0xff, 0xff, 0x00}}), (Bytes{0x12, 0xff}));
  EXPECT_EQ(grey_of({.width = 4, .height = 1, .bits = 2, .rows = {0, 0b00011011}}), (Bytes{0, 85, 170, 255}));
  EXPECT_EQ(grey_of({.width = 2, .height = 1, .kind = 4, .rows = {0, 7, 255, 9, 0}}), (Bytes{7, 9}));
}

TEST(PngPicture, RowsThatAreWovenAreTakenApart) {
  const RawPng woven{.width = 2, .height = 2, .weave = 1, .rows = {0, 1, 0, 2, 0, 3, 4}};
  EXPECT_EQ(grey_of(woven), (Bytes{1, 2, 3, 4}));
}

TEST(PngPicture, ColoursAreInTheOrderOfOpenCv) {
  const Picture colours{Shades::colours, 2, 1, {1, 2, 3, 250, 251, 252}};
  const auto read = decode_png(test::png_bytes(colours), "a.png", Shades::colours);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, colours);
  const auto grey = decode_png(test::png_bytes(test::plain_picture(1, 1, 7)), "a.png", Shades::colours);
  ASSERT_TRUE(grey);
  EXPECT_EQ(grey->samples, (Bytes{7, 7, 7}));
}

TEST(PngPicture, WhatEndsTooEarlyIsSaid) {
  const Bytes whole = test::png_bytes(test::plain_picture(30, 20, 77));
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const auto read = decode_png(ByteView(whole).first(size), "a.png", Shades::grey);
    ASSERT_FALSE(read) << size;
    EXPECT_EQ(read.error().code, ErrorCode::corrupt);
  }
  const auto read = decode_png(ByteView(whole).first(whole.size() / 2), "a.png", Shades::grey);
  EXPECT_THAT(read.error().message, HasSubstr("a.png: no PNG that can be read (it ends too early)"));
}

TEST(PngPicture, DamageIsRefusedOrLeavesTheSizeAsItIs) {
  const Bytes whole = test::png_bytes(RawPng{.width = 3, .height = 2, .kind = 2, .rows = Bytes(20, 0)});
  for (std::size_t i = 0; i < whole.size(); ++i) {
    for (const std::uint8_t change : {std::uint8_t{0x01}, std::uint8_t{0x80}, std::uint8_t{0xff}}) {
      Bytes changed = whole;
      changed[i] ^= change;
      if (const auto read = decode_png(changed, "a.png", Shades::grey)) {
        EXPECT_EQ(read->samples.size(), 6U) << i;
      }
    }
  }
}

TEST(PngPicture, TooManyPixelsAreRefusedBeforeTheyAreUnpacked) {
  const auto read =
      decode_png(test::png_bytes(RawPng{.width = 60'000, .height = 60'000, .rows = {0}}), "a.png", Shades::grey);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::exhausted);
  EXPECT_THAT(read.error().message, HasSubstr("a.png: is 60000 x 60000 pixels, at most 134217728"));
}

}  // namespace
}  // namespace weft::images
