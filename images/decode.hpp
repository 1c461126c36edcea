#pragma once
#include <string_view>

#include "core/bytes.hpp"
#include "images/picture.hpp"

namespace weft::images {

/// Makes a picture of the bytes of a PNG, a JPEG or a PGM, whichever they begin as; `file` is for messages. corrupt:
/// they begin as none of these; else as decode_png, decode_jpeg and decode_pgm.
Result<Picture> decode(ByteView bytes, std::string_view file, Shades shades);

}  // namespace weft::images
