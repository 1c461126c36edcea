#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/bytes.hpp"
#include "storage/formats/not_understood.hpp"

namespace weft::formats {

/// Holds grey values row by row, the top row first.
struct GreyImage {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint16_t white = 255;  ///< the largest value
  std::vector<std::uint16_t> pixels;
  std::vector<std::uint16_t> opacities = {};  ///< one a pixel, `white` is opaque; empty: all are
  bool operator==(const GreyImage&) const = default;
};

/// Reads a PNG or a PGM, by its first bytes. Errors as `read_png` and `read_pgm` have them.
Result<Read<GreyImage>> read_grey_image(ByteView bytes, std::string_view file);

}  // namespace weft::formats
