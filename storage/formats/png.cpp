#include "storage/formats/png.hpp"

#include <png.h>

#include <memory>
#include <string>

#include "images/png.hpp"
#include "storage/formats/pgm.hpp"

namespace weft::formats {
namespace {

struct Free {
  void operator()(png_image* image) const { png_image_free(image); }
};

tl::unexpected<Error> damaged(std::string_view file, const png_image& image) {
  return fail(ErrorCode::corrupt,
              std::string(file) + ": no PNG that can be read (" + image.message + "); write it anew");
}

/// Makes an image grey. Sums colours and does not divide, so no mean is rounded: white is three times as high.
GreyImage grey_of(const Bytes& samples, const png_image& image) {
  constexpr std::uint16_t kFull = 255;
  const std::size_t channels = PNG_IMAGE_SAMPLE_CHANNELS(image.format);
  const bool has_opacity = (image.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  const std::size_t shades = channels - (has_opacity ? 1 : 0);
  GreyImage grey{image.width, image.height, static_cast<std::uint16_t>(kFull * shades), {}};
  for (std::size_t at = 0; at < samples.size(); at += channels) {
    std::uint16_t sum = 0;
    for (std::size_t i = 0; i < shades; ++i) sum = static_cast<std::uint16_t>(sum + samples[at + i]);
    grey.pixels.push_back(sum);
    if (has_opacity) grey.opacities.push_back(static_cast<std::uint16_t>(samples[at + shades] * shades));
  }
  return grey;
}

}  // namespace

Result<Read<GreyImage>> read_png(ByteView bytes, std::string_view file) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, Free> freed(&image);
  if (png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()) == 0) return damaged(file, image);
  constexpr std::size_t kMost = 1U << 28U;
  if (std::size_t{image.width} * image.height > kMost) {
    return fail(ErrorCode::exhausted, std::string(file) + ": has " + std::to_string(image.width) + " x " +
                                          std::to_string(image.height) + " pixels, at most 2^28 are read");
  }
  image.flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // maps are shades, not light: nothing is to be bent by a gamma
  image.format &= PNG_FORMAT_FLAG_ALPHA | PNG_FORMAT_FLAG_COLOR;
  Bytes samples(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, samples.data(), 0, nullptr) == 0) return damaged(file, image);
  return Read<GreyImage>{grey_of(samples, image), {}};
}

Result<Read<GreyImage>> read_grey_image(ByteView bytes, std::string_view file) {
  return images::is_png(bytes) ? read_png(bytes, file) : read_pgm(bytes, file);
}

}  // namespace weft::formats
