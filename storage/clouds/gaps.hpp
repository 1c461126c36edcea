#pragma once
#include <cstdint>

#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::clouds {

/// Holds the gaps between codes as docs/formats/cloud.md splits them.
struct Gaps {
  Bytes tokens;  ///< one a code
  Bytes tails;   ///< whole words of 8 bytes, the last one zero
};

/// Splits the gaps between `codes`: u64 each, little-endian. corrupt: one below the one before, or 2^63 and more.
Result<Gaps> gaps_from_codes(ByteView codes);

/// Writes the codes, 8 bytes a token, to `out`. corrupt: a token that means nothing, tails of another length than the
/// tokens ask for, a code of 2^63 and more.
Result<void> codes_from_gaps(ByteView tokens, ByteView tails, std::uint8_t* out);

}  // namespace weft::clouds
