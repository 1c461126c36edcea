#pragma once
#include "core/bytes.hpp"
#include "storage/formats/grey_image.hpp"

namespace weft::formats {

/// Reads P5 (binary) and P2 (text), white up to 65535 (two bytes a pixel, the high one first, above 255), comments in
/// the header. Bytes after the image are listed as not understood.
/// invalid or corrupt, naming file and line, in binary data the pixel: another magic, sizes not in [1, 65535], short
/// data, a value above white.
Result<Read<GreyImage>> read_pgm(ByteView bytes, std::string_view file);
/// Writes P5.
Bytes pgm_bytes(const GreyImage& image);

}  // namespace weft::formats
