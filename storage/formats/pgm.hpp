#pragma once
#include "core/bytes.hpp"
#include "storage/formats/grey_image.hpp"

namespace weft::formats {

/// Reads a PGM as images::read_pgm has it. Bytes after the image are listed as not understood.
Result<Read<GreyImage>> read_pgm(ByteView bytes, std::string_view file);
/// Writes P5.
Bytes pgm_bytes(const GreyImage& image);

}  // namespace weft::formats
