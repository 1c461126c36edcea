#pragma once
#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::formats {

/// Undoes LZF, the coding of PCD's binary_compressed. A control byte c < 32: c + 1 literal bytes follow. Otherwise a
/// copy of 2 + (c >> 5) bytes (7 there: one byte more is added) from so far back: low 5 bits of c, then one byte,
/// + 1. corrupt: the bytes end early, a copy begins before the output, or the output has another size; names the
/// byte.
Result<Bytes> lzf_decompress(ByteView packed, std::size_t size);

}  // namespace weft::formats
