#include "images/jpeg.hpp"

#include <gmock/gmock.h>
#include <turbojpeg.h>

#include <memory>

namespace weft::images {
namespace {

using testing::HasSubstr;

struct EndEncoder {
  void operator()(void* encoder) const { tjDestroy(encoder); }
};

Bytes jpeg_of(const Picture& picture) {
  const std::unique_ptr<void, EndEncoder> encoder(tjInitCompress());
  const bool is_grey = picture.shades == Shades::grey;
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  constexpr int kQuality = 95;
  EXPECT_EQ(
      tjCompress2(encoder.get(), picture.samples.data(), picture.width, 0, picture.height,
                  is_grey ? TJPF_GRAY : TJPF_BGR, &bytes, &size, is_grey ? TJSAMP_GRAY : TJSAMP_444, kQuality, 0),
      0);
  Bytes out(bytes, bytes + size);
  tjFree(bytes);
  return out;
}

/// Returns a picture of one colour.
Picture painted(int width, int height, std::uint8_t blue, std::uint8_t green, std::uint8_t red) {
  Picture picture{Shades::colours, width, height, {}};
  for (int i = 0; i < width * height; ++i) picture.samples.insert(picture.samples.end(), {blue, green, red});
  return picture;
}

TEST(JpegPicture, GreyComesBack) {
  const auto read = decode_jpeg(jpeg_of({Shades::grey, 3, 2, Bytes(6, 130)}), "a.jpg", Shades::grey);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, (Picture{Shades::grey, 3, 2, Bytes(6, 130)}));
}

TEST(JpegPicture, ColoursComeBackAndBecomeTheGreyOfTheirWeights) {
  const Bytes bytes = jpeg_of(painted(20, 10, 30, 60, 200));
  const auto colours = decode_jpeg(bytes, "a.jpg", Shades::colours);
  ASSERT_TRUE(colours) << colours.error().message;
  EXPECT_NEAR(colours->samples[0], 30, 2);
  EXPECT_NEAR(colours->samples[1], 60, 2);
  EXPECT_NEAR(colours->samples[2], 200, 2);
  const auto grey = decode_jpeg(bytes, "a.jpg", Shades::grey);
  ASSERT_TRUE(grey) << grey.error().message;
  EXPECT_NEAR(grey->samples[0], 0.114 * 30 + 0.587 * 60 + 0.299 * 200, 1);
}

TEST(JpegPicture, WhatEndsTooEarlyIsRefused) {
  const Bytes whole = jpeg_of(painted(64, 64, 30, 60, 200));
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{3}, std::size_t{40}, whole.size() / 2, whole.size() - 3}) {
    const auto read = decode_jpeg(ByteView(whole).first(size), "a.jpg", Shades::grey);
    ASSERT_FALSE(read) << size;
    EXPECT_EQ(read.error().code, ErrorCode::corrupt);
    EXPECT_THAT(read.error().message, HasSubstr("a.jpg: no JPEG that can be read ("));
  }
}

/// Returns where the frame's header begins: 8 bits, height, width, how many colours.
std::size_t frame_of(const Bytes& jpeg) {
  std::size_t at = 2;
  while (jpeg[at + 1] != 0xc0) at += 2U + jpeg[at + 2] * 256U + jpeg[at + 3];
  return at + 4;
}

TEST(JpegPicture, TooManyPixelsAreRefusedBeforeTheyAreUnpacked) {
  Bytes bytes = jpeg_of({Shades::grey, 8, 8, Bytes(64, 9)});
  for (std::size_t i = 1; i <= 4; ++i) bytes[frame_of(bytes) + i] = 0xf0;
  const auto read = decode_jpeg(bytes, "a.jpg", Shades::grey);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::exhausted);
  EXPECT_THAT(read.error().message, HasSubstr("a.jpg: is 61680 x 61680 pixels"));
}

TEST(JpegPicture, TwelveBitsASampleAreRefused) {
  Bytes bytes = jpeg_of({Shades::grey, 8, 8, Bytes(64, 9)});
  bytes[frame_of(bytes)] = 12;
  const auto read = decode_jpeg(bytes, "a.jpg", Shades::grey);
  ASSERT_FALSE(read);
  EXPECT_THAT(read.error().message, HasSubstr("precision 12"));
}

}  // namespace
}  // namespace weft::images
