#pragma once
#include <cstddef>

#include "core/bytes.hpp"

namespace weft::bus {

/// Bounds the padding of a message: RTPS carries multiples of 4 bytes, and a vendor may hand over what fills them up.
/// How much it is stands in the low two bits of the encapsulation header's options (RTPS 2.5, 10.2.1.2), so that a
/// reader gets the very bytes that were written: with padding on the wire, without it and with options 0 inside.
inline constexpr std::size_t kMostPadding = 3;

Bytes with_padding(ByteView cdr);
Bytes without_padding(ByteView padded);

}  // namespace weft::bus
