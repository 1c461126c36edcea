#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "core/bytes.hpp"
#include "core/result.hpp"

/// Reads pictures: PNG by libpng, JPEG by TurboJPEG, PGM by a reader of its own.
namespace weft::images {

/// Tells what the samples of a picture are; the value is how many bytes a pixel has.
enum class Shades : std::uint8_t {
  grey = 1,
  colours = 3,  ///< blue, green and red, in the order in which OpenCV has them
};

/// Holds samples of 8 bits, pixel by pixel, row by row from the top, without padding.
struct Picture {
  Shades shades = Shades::grey;
  int width = 0;
  int height = 0;
  Bytes samples;
  bool operator==(const Picture&) const = default;
};

/// Bounds the pixels of a picture: what claims more is refused before memory is taken for it.
inline constexpr std::size_t kMostPixels = std::size_t{1} << 27U;

/// Returns a black picture of that size. exhausted: it would have more than kMostPixels pixels.
Result<Picture> blank_picture(std::string_view file, Shades shades, std::size_t width, std::size_t height);

}  // namespace weft::images
