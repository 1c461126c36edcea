#pragma once
#include <string_view>

#include "core/bytes.hpp"
#include "storage/formats/grey_image.hpp"

namespace weft::formats {

/// Reads every PNG: a coloured pixel becomes the mean of its red, green and blue, as map_server takes it, 16 bits a
/// channel become 8. corrupt: damaged or short data, naming the file; exhausted: more than 2^28 pixels.
Result<Read<GreyImage>> read_png(ByteView bytes, std::string_view file);

}  // namespace weft::formats
