#pragma once
#include "core/bytes.hpp"
#include "core/result.hpp"
#include "storage/spool.hpp"

namespace weft::storage {

/// Writes and reads the file in which a robot's spool keeps why it stands (docs/formats/spool.md). corrupt: no such
/// file, or damaged; newer: of a later format.
Bytes encode(const Stops& stops);
Result<Stops> decode_stops(ByteView bytes);

}  // namespace weft::storage
