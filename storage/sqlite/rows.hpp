#pragma once
#include <cstdint>
#include <optional>

#include "core/bytes.hpp"
#include "core/ids.hpp"
#include "core/result.hpp"
#include "storage/content_coder.hpp"

/// Defines the forms that rows and contents have in the columns of the store; docs/formats/store.md.
namespace weft::storage::sqlite {

/// Returns canonical bytes followed by the first 8 bytes of their SHA-256, so that a flipped bit is seen.
Bytes guard_row(Bytes canonical);
/// Returns the canonical bytes; none when the row is damaged.
std::optional<ByteView> unguard_row(ByteView row);

/// Returns the coding with that number. corrupt: no coding has it.
Result<Coding> coding_from(std::uint64_t number);

/// Holds a content's row but for its bytes, as numbers that may be damaged.
struct ContentRow {
  ContentHash hash;
  std::uint64_t size = 0;    ///< of the content itself
  std::uint64_t coding = 0;  ///< a number, which may be none of Coding
};
/// Returns the value of column `sum`: it tells a damaged row without expanding it, twenty times as fast as SHA-256.
/// It is XXH3-64 of the bytes as kept; its seed is that of hash, size and coding.
std::uint64_t content_sum(const ContentRow& row, ByteView kept);

}  // namespace weft::storage::sqlite
