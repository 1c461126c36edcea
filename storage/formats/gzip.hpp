#pragma once
#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::formats {

/// By its first two bytes.
bool is_gzip(ByteView bytes);
/// All members of a gzip file. corrupt: damaged or short; exhausted: more than `at_most` bytes come out.
Result<Bytes> gunzip(ByteView bytes, std::size_t at_most);

}  // namespace weft::formats
