#include "storage/formats/png.hpp"

#include <gtest/gtest.h>
#include <png.h>

#include "storage/formats/pgm.hpp"

namespace weft::formats {
namespace {

/// Returns a PNG as libpng writes it: `samples` are all channels of all pixels.
Bytes png_of(std::uint32_t width, std::uint32_t height, std::uint32_t format, const Bytes& samples) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = format;
  png_alloc_size_t size = 0;
  EXPECT_NE(png_image_write_to_memory(&image, nullptr, &size, 0, samples.data(), 0, nullptr), 0);
  Bytes bytes(size);
  EXPECT_NE(png_image_write_to_memory(&image, bytes.data(), &size, 0, samples.data(), 0, nullptr), 0);
  bytes.resize(size);
  return bytes;
}

TEST(Png, GreysAreTakenAsTheyAre) {
  const auto read = read_png(png_of(2, 2, PNG_FORMAT_GRAY, {0, 1, 205, 255}), "a.png");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->value, (GreyImage{2, 2, 255, {0, 1, 205, 255}}));
}

TEST(Png, OpacityStandsBesideTheGrey) {
  const auto read = read_png(png_of(2, 1, PNG_FORMAT_GA, {254, 255, 9, 0}), "a.png");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->value.opacities, (std::vector<std::uint16_t>{255, 0}));
  EXPECT_EQ(read->value.pixels[0], 254);
}

TEST(Png, ColoursBecomeTheirMean) {
  const auto read = read_png(png_of(2, 1, PNG_FORMAT_RGBA, {255, 255, 255, 255, 10, 20, 33, 128}), "a.png");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->value, (GreyImage{2, 1, 765, {765, 63}, {765, 384}}));
}

TEST(Png, DamageIsRefusedWithTheFile) {
  const Bytes whole = png_of(2, 2, PNG_FORMAT_GRAY, {0, 1, 205, 255});
  for (std::size_t size = 0; size < whole.size() / 2; ++size) {
    const auto read = read_png(ByteView(whole).first(size), "a.png");
    ASSERT_FALSE(read.has_value()) << size;
    EXPECT_TRUE(read.error().message.starts_with("a.png: no PNG that can be read (")) << read.error().message;
  }
  std::size_t refused = 0;
  for (std::size_t i = 0; i < whole.size(); ++i) {
    Bytes changed = whole;
    changed[i] ^= 0xffU;
    refused += read_png(changed, "a.png").has_value() ? 0 : 1;  // libpng lets damage to what it does not need pass
  }
  EXPECT_GT(refused, whole.size() / 4);
}

TEST(GreyImages, AreToldApartByTheirFirstBytes) {
  EXPECT_TRUE(read_grey_image(png_of(1, 1, PNG_FORMAT_GRAY, {7}), "a.pgm").has_value());
  EXPECT_TRUE(read_grey_image(pgm_bytes({1, 1, 255, {7}}), "a.png").has_value());
  EXPECT_EQ(read_grey_image(Bytes{'G', 'I', 'F'}, "a").error().message,
            "a:1: the file begins with neither P5 nor P2");
}

}  // namespace
}  // namespace weft::formats
