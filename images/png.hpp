#pragma once
#include <string_view>

#include "core/bytes.hpp"
#include "images/picture.hpp"

namespace weft::images {

/// Returns whether the bytes are a PNG's, by the first ones.
bool is_png(ByteView bytes);

/// Reads every PNG: opacity is left out, 16 bits a sample become the upper 8, colours become grey by the weights
/// 0.299, 0.587 and 0.114 (of the light itself where the file tells its gamma), as OpenCV's IMREAD_GRAYSCALE has it,
/// byte by byte. corrupt: damaged or short data, naming the file; exhausted: more than kMostPixels.
Result<Picture> decode_png(ByteView bytes, std::string_view file, Shades shades);

}  // namespace weft::images
