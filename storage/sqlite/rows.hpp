#pragma once
#include <optional>

#include "core/bytes.hpp"
#include "core/result.hpp"

/// How rows and contents stand in the columns of the store; docs/formats/store.md.
namespace weft::storage::sqlite {

/// Canonical bytes followed by the first 8 bytes of their SHA-256, so that a flipped bit is seen.
Bytes guard_row(Bytes canonical);
/// The canonical bytes; none when the row is damaged.
std::optional<ByteView> unguard_row(ByteView row);

enum class Coding : std::uint64_t { raw = 0, zstd = 1, cloud = 2 };

struct Coded {
  Coding coding = Coding::raw;
  Bytes bytes;  ///< empty for raw: the content itself is stored
};

/// Compressed, unless that saves nothing. What comes back is the same to the byte, clouds included.
Coded encode_content(ByteView content);
/// corrupt: the bytes do not decode to `size` bytes.
Result<Bytes> decode_content(Coding coding, ByteView stored, std::uint64_t size);

}  // namespace weft::storage::sqlite
