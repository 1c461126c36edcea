#pragma once
#include <cstddef>

#include "core/bytes.hpp"

namespace weft::bus {

/// RTPS carries messages in multiples of 4 bytes, and a vendor may hand over the padding. How much it is stands in
/// the low two bits of the encapsulation header's options (RTPS 2.5, 10.2.1.2), so that a reader gets the very bytes
/// that were written: with padding on the wire, without it and with options 0 inside.
inline constexpr std::size_t kMostPadding = 3;

Bytes with_padding(ByteView cdr);
Bytes without_padding(ByteView padded);

}  // namespace weft::bus
