#include "idl/bus/padding.hpp"

namespace weft::bus {
namespace {
constexpr std::size_t kHeader = 4;
constexpr std::size_t kOptions = 3;
constexpr std::uint8_t kPaddingBits = 3;
}  // namespace

Bytes with_padding(ByteView cdr) {
  const std::size_t padding = (4 - cdr.size() % 4) % 4;
  Bytes padded;
  padded.reserve(cdr.size() + padding);
  padded.assign(cdr.begin(), cdr.end());
  padded.resize(cdr.size() + padding);
  if (padded.size() >= kHeader) padded[kOptions] = static_cast<std::uint8_t>(padding);
  return padded;
}

Bytes without_padding(ByteView padded) {
  Bytes cdr(padded.begin(), padded.end());
  if (cdr.size() < kHeader) return cdr;
  const std::size_t padding = cdr[kOptions] & kPaddingBits;
  // Fragmented messages come with their exact length although the bits say that they were padded.
  if (cdr.size() % 4 == 0 && cdr.size() >= kHeader + padding) cdr.resize(cdr.size() - padding);
  cdr[kOptions] = 0;
  return cdr;
}

}  // namespace weft::bus
