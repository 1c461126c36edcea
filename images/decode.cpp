#include "images/decode.hpp"

#include <string>

#include "images/jpeg.hpp"
#include "images/pgm.hpp"
#include "images/png.hpp"

namespace weft::images {

Result<Picture> decode(ByteView bytes, std::string_view file, Shades shades) {
  if (is_png(bytes)) return decode_png(bytes, file, shades);
  if (is_jpeg(bytes)) return decode_jpeg(bytes, file, shades);
  if (is_pgm(bytes)) return decode_pgm(bytes, file, shades);
  return fail(ErrorCode::corrupt, std::string(file) + (bytes.empty() ? ": is empty" : ": begins as no picture") +
                                      "; PNG, JPEG and PGM are read");
}

}  // namespace weft::images
