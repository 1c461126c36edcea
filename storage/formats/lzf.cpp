#include "storage/formats/lzf.hpp"

#include <string>

namespace weft::formats {

Result<Bytes> lzf_decompress(ByteView packed, std::size_t size) {
  Bytes out;
  out.reserve(size);
  std::size_t at = 0;
  const auto corrupt = [&at](const std::string& what) {
    return fail(ErrorCode::corrupt, "compressed data at byte " + std::to_string(at) + ": " + what);
  };
  while (at < packed.size()) {
    const std::uint8_t control = packed[at++];
    if (control < 32U) {
      const std::size_t literals = control + 1U;
      if (literals > packed.size() - at) return corrupt("it ends within literal bytes");
      if (literals > size - out.size()) return corrupt("more comes out than was stated");
      out.insert(out.end(), packed.begin() + static_cast<std::ptrdiff_t>(at),
                 packed.begin() + static_cast<std::ptrdiff_t>(at + literals));
      at += literals;
      continue;
    }
    std::size_t length = 2U + (control >> 5U);
    constexpr std::size_t kLonger = 2U + 7U;
    const std::size_t more = length == kLonger ? 2 : 1;
    if (more > packed.size() - at) return corrupt("it ends within a copy");
    if (length == kLonger) length += packed[at++];
    const std::size_t back = ((control & 31U) << 8U) + packed[at++] + 1U;
    if (back > out.size()) return corrupt("a copy begins before the data");
    if (length > size - out.size()) return corrupt("more comes out than was stated");
    for (std::size_t i = 0; i < length; ++i) out.push_back(out[out.size() - back]);  // may overlap itself
  }
  if (out.size() != size) {
    return corrupt(std::to_string(out.size()) + " bytes come out, " + std::to_string(size) + " were stated");
  }
  return out;
}

}  // namespace weft::formats
