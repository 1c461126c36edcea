#pragma once
#include "core/bytes.hpp"
#include "core/result.hpp"

namespace weft::formats {

/// Returns whether the bytes are a gzip file's, by the first two of them.
bool is_gzip(ByteView bytes);
/// Expands all members of a gzip file. corrupt: damaged or short; exhausted: more than `at_most` bytes come out.
Result<Bytes> gunzip(ByteView bytes, std::size_t at_most);
/// Packs the bytes into a gzip file of one member, without a name and a time. exhausted: there is no memory for it.
Result<Bytes> gzip(ByteView bytes);

}  // namespace weft::formats
