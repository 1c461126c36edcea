#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/bytes.hpp"
#include "images/picture.hpp"

namespace weft::images {

/// Holds a PGM as it stands in the file: grey values row by row, the top row first.
struct Pgm {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint16_t white = 255;  ///< the largest value
  std::vector<std::uint16_t> pixels;
  std::string_view rest;      ///< what follows the image, "bytes" or "words"; empty: nothing does
  std::size_t rest_line = 0;  ///< the line in which it begins
};

/// Returns whether the bytes are a PGM's, by the first ones.
bool is_pgm(ByteView bytes);

/// Reads P5 (binary) and P2 (text), white up to 65535 (two bytes a pixel, the high one first, above 255), comments in
/// the header. invalid or corrupt, naming file and line, in binary data the pixel: another magic, sizes not in
/// [1, 65535], short data, a value above white.
Result<Pgm> read_pgm(ByteView bytes, std::string_view file);

/// Reads it with white as 255: 16 bits a pixel become the upper 8, other depths are stretched. Errors are those of
/// read_pgm; exhausted: more than kMostPixels.
Result<Picture> decode_pgm(ByteView bytes, std::string_view file, Shades shades);

}  // namespace weft::images
