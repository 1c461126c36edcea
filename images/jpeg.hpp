#pragma once
#include <string_view>

#include "core/bytes.hpp"
#include "images/picture.hpp"

namespace weft::images {

/// Returns whether the bytes are a JPEG's, by the first ones.
bool is_jpeg(ByteView bytes);

/// Reads a JPEG of grey or of three colours as its pixels are stored: a note that it is to be turned (EXIF) changes
/// nothing. corrupt: damaged or short data; invalid: it is of four colours, for printing; exhausted: more than
/// kMostPixels. All name the file.
Result<Picture> decode_jpeg(ByteView bytes, std::string_view file, Shades shades);

}  // namespace weft::images
