#include "images/pgm.hpp"

#include <gtest/gtest.h>

#include <string>

namespace weft::images {
namespace {

Bytes raw(const std::string& text) {
  return {text.begin(), text.end()};
}

Bytes samples_of(const std::string& text, Shades shades = Shades::grey) {
  const auto picture = decode_pgm(raw(text), "a.pgm", shades);
  EXPECT_TRUE(picture) << picture.error().message;
  return picture ? picture->samples : Bytes{};
}

TEST(PgmPicture, BytesAreTakenAsTheyAre) {
  const auto picture = decode_pgm(raw("P5\n2 1\n255\n\x07z"), "a.pgm", Shades::grey);
  ASSERT_TRUE(picture) << picture.error().message;
  EXPECT_EQ(*picture, (Picture{Shades::grey, 2, 1, {7, 'z'}}));
}

TEST(PgmPicture, OtherDepthsBecomeEightBits) {
  EXPECT_EQ(samples_of("P2 3 1 65535 255 256 65535"), (Bytes{0, 1, 255})) << "the upper byte of two";
  EXPECT_EQ(samples_of("P2 3 1 1023 0 512 1023"), (Bytes{0, 127, 255}));
  EXPECT_EQ(samples_of("P2 2 1 1 0 1"), (Bytes{0, 255}));
}

TEST(PgmPicture, AsColoursEachIsThreeTimesTheGrey) {
  EXPECT_EQ(samples_of("P2 2 1 255 9 8", Shades::colours), (Bytes{9, 9, 9, 8, 8, 8}));
}

TEST(PgmPicture, WhatFollowsTheImageIsTold) {
  const auto pgm = read_pgm(raw("P2 1 1 255\n9\n\n3"), "a.pgm");
  ASSERT_TRUE(pgm) << pgm.error().message;
  EXPECT_EQ(pgm->rest, "words");
  EXPECT_EQ(pgm->rest_line, 4U);
}

TEST(PgmPicture, ShortDataIsRefusedWithTheFile) {
  const auto picture = decode_pgm(raw("P5 2 2 255\nabc"), "a.pgm", Shades::grey);
  ASSERT_FALSE(picture);
  EXPECT_EQ(picture.error().message, "a.pgm: the image ends after 3 of 4 pixels");
}

}  // namespace
}  // namespace weft::images
