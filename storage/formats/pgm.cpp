#include "storage/formats/pgm.hpp"

#include <string>

#include "core/byte_writer.hpp"
#include "images/pgm.hpp"

namespace weft::formats {

Result<Read<GreyImage>> read_pgm(ByteView bytes, std::string_view file) {
  Result<images::Pgm> pgm = images::read_pgm(bytes, file);
  if (!pgm) return fail(pgm.error());
  Leftovers leftovers;
  if (!pgm->rest.empty()) leftovers.note(std::string(pgm->rest) + " after the image", pgm->rest_line);
  return Read<GreyImage>{{pgm->width, pgm->height, pgm->white, std::move(pgm->pixels)}, leftovers.take()};
}

Bytes pgm_bytes(const GreyImage& image) {
  const std::string header = "P5\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n" +
                             std::to_string(image.white) + "\n";
  ByteWriter out;
  out.raw({reinterpret_cast<const std::uint8_t*>(header.data()), header.size()});
  constexpr std::uint16_t kOneByte = 255;
  for (const std::uint16_t value : image.pixels) {
    if (image.white > kOneByte) out.number(static_cast<std::uint8_t>(value >> 8U));
    out.number(static_cast<std::uint8_t>(value));
  }
  return out.take();
}

}  // namespace weft::formats
