#include "storage/sqlite/parts.hpp"

#include "core/network/codec.hpp"
#include "storage/sqlite/rows.hpp"

namespace weft::storage::sqlite {

Result<StoreRow> current_row(const Parts& parts) {
  Result<StoreRow> row = read_store_row(parts.statements);
  if (row && row->epoch != parts.epoch) {
    return fail(ErrorCode::stale, "map store " + parts.directory.string() + ": epoch " +
                                      std::to_string(parts.epoch.value) +
                                      " has ended, another server opened the store with epoch " +
                                      std::to_string(row->epoch.value) + "; stop this one");
  }
  return row;
}

Result<Bytes> read_content(const Parts& parts, const ContentHash& hash) {
  Query query(parts.statements.read_content);
  query << hash;
  const Result<bool> found = query.step();
  if (!found) return fail(found.error());
  if (!*found) return fail(ErrorCode::not_found, "it is not stored");
  if (query.number(0) != 0) return fail(ErrorCode::corrupt, "it was found damaged before");
  Result<Bytes> bytes = parts.coder->decode(static_cast<Coding>(query.number(1)), query.blob(3), query.number(2));
  if (bytes && hash_bytes(*bytes) != hash) return fail(ErrorCode::corrupt, "its SHA-256 differs");
  return bytes;
}

void quarantine(Parts& parts, const ContentHash& hash) {
  if (!parts.quarantined.insert(hash).second) return;
  auto write = WriteTransaction::begin(parts.database);
  if (!write) return;
  Result<StoreRow> row = current_row(parts);
  if (!row) return;
  {
    Query query(parts.statements.quarantine);
    query << hash;
    if (!query.step().value_or(false)) return;
    --row->contents;
    row->content_bytes -= query.number(0);
    if (!query.step()) return;  // RETURNING: the statement ends with the step after its row
  }
  if (write_store_row(parts.statements, *row) && write->commit()) parts.row = *row;
}

}  // namespace weft::storage::sqlite
