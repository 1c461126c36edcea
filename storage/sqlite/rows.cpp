#include "storage/sqlite/rows.hpp"

#include <xxhash.h>

#include <algorithm>
#include <string>

#include "core/byte_writer.hpp"
#include "core/network/codec.hpp"

namespace weft::storage::sqlite {
namespace {

constexpr std::size_t kGuardBytes = 8;

}  // namespace

Bytes guard_row(Bytes canonical) {
  const ContentHash hash = hash_bytes(canonical);
  canonical.insert(canonical.end(), hash.bytes.begin(), hash.bytes.begin() + kGuardBytes);
  return canonical;
}

std::optional<ByteView> unguard_row(ByteView row) {
  if (row.size() < kGuardBytes) return std::nullopt;
  const ByteView canonical = row.first(row.size() - kGuardBytes);
  const ContentHash hash = hash_bytes(canonical);
  if (!std::equal(hash.bytes.begin(), hash.bytes.begin() + kGuardBytes, row.last(kGuardBytes).begin())) {
    return std::nullopt;
  }
  return canonical;
}

Result<Coding> coding_from(std::uint64_t number) {
  if (number <= static_cast<std::uint64_t>(Coding::cloud)) return static_cast<Coding>(number);
  return fail(ErrorCode::corrupt, "unknown coding " + std::to_string(number));
}

std::uint64_t content_sum(const ContentRow& row, ByteView kept) {
  ByteWriter head;
  head.reserve(sizeof(row));
  head.id(row.hash);
  head.number(row.size);
  head.number(row.coding);
  const ByteView told = head.view();
  return XXH3_64bits_withSeed(kept.data(), kept.size(), XXH3_64bits(told.data(), told.size()));
}

}  // namespace weft::storage::sqlite
