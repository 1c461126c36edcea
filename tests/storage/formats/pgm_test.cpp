#include "storage/formats/pgm.hpp"

#include <gtest/gtest.h>

namespace weft::formats {
namespace {

Bytes raw(const std::string& text) {
  return {text.begin(), text.end()};
}

TEST(Pgm, TextWithComments) {
  const auto image = read_pgm(raw("P2 # magic\n# by hand\n3 2\n15\n0 1 2\n3 4 15\n"), "a.pgm");
  ASSERT_TRUE(image.has_value()) << image.error().message;
  EXPECT_EQ(image->value, (GreyImage{3, 2, 15, {0, 1, 2, 3, 4, 15}}));
}

TEST(Pgm, TwoBytesAPixelReadBack) {
  const GreyImage image{2, 1, 1000, {999, 258}};
  const Bytes bytes = pgm_bytes(image);
  EXPECT_EQ(Bytes(bytes.end() - 2, bytes.end()), (Bytes{1, 2}));  // the high byte first
  const auto read = read_pgm(bytes, "a.pgm");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->value, image);
}

TEST(Pgm, PixelsThatLookLikeTextAreLeftAlone) {
  const auto image = read_pgm(raw("P5\n2 2\n255\n#\n 1"), "a.pgm");
  ASSERT_TRUE(image.has_value()) << image.error().message;
  EXPECT_EQ(image->value.pixels, (std::vector<std::uint16_t>{'#', '\n', ' ', '1'}));
  EXPECT_TRUE(image->not_understood.empty());
}

TEST(Pgm, WhatFollowsTheImageIsListed) {
  const auto image = read_pgm(raw("P5 1 1 255\nab"), "a.pgm");
  ASSERT_TRUE(image.has_value());
  ASSERT_EQ(image->not_understood.size(), 1U);
  EXPECT_EQ(image->not_understood[0].what, "bytes after the image");
}

TEST(Pgm, WhatIsWrongIsSaid) {
  const std::vector<std::pair<std::string, std::string>> table = {
      {"P6 1 1 255\nabc", "a.pgm:1: the file begins with neither P5 nor P2"},
      {"P5\n0 1 255\n", "a.pgm:2: the width must be a whole number in [1, 65535]"},
      {"P5\n1 x 255\n", "a.pgm:2: the height must be a whole number in [1, 65535]"},
      {"P5\n1 1\n65536\n", "a.pgm:3: the white must be a whole number in [1, 65535]"},
      {"P5 2 2 255\nabc", "a.pgm: the image ends after 3 of 4 pixels"},
      {"P5 1 1 10\na", "a.pgm: pixel 0 is 97, above white, 10"},
      {"P2\n2 1\n255\n1\n", "a.pgm:5: the image ends after 1 of 2 pixels"},
      {"P2\n2 1\n255\n1 256\n", "a.pgm:4: '256' is no pixel in [0, 255]"},
      {"P2 60000 60000 255\n1", "a.pgm:1: the file is too short for its pixels"}};
  for (const auto& [text, message] : table) {
    const auto image = read_pgm(raw(text), "a.pgm");
    ASSERT_FALSE(image.has_value()) << message;
    EXPECT_EQ(image.error().message, message);
  }
}

}  // namespace
}  // namespace weft::formats
