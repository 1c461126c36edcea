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

namespace {

/// Returns the row of read_content, if it is there and not quarantined. not_found; corrupt: quarantined.
Result<ContentRow> find_content_row(Query& query, const ContentHash& hash) {
  query << hash;
  const Result<bool> found = query.step();
  if (!found) return fail(found.error());
  if (!*found) return fail(ErrorCode::not_found, "it is not stored");
  if (query.number(0) != 0) return fail(ErrorCode::corrupt, "it was found damaged before");
  return ContentRow{hash, query.number(2), query.number(1)};
}

}  // namespace

Result<Bytes> expand_content(ContentCoder& coder, const ContentRow& row, ByteView kept) {
  const Result<Coding> coding = coding_from(row.coding);
  if (!coding) return fail(coding.error());
  Result<Bytes> bytes = coder.decode(*coding, kept, row.size);
  if (bytes && hash_bytes(*bytes) != row.hash) return fail(ErrorCode::corrupt, "its SHA-256 differs");
  return bytes;
}

Result<Bytes> read_content(const Parts& parts, const ContentHash& hash) {
  Query query(parts.statements.read_content);
  const Result<ContentRow> row = find_content_row(query, hash);
  if (!row) return fail(row.error());
  return expand_content(*parts.coder, *row, query.blob(3));
}

Result<StoredContent> read_stored(const Parts& parts, const ContentHash& hash) {
  Query query(parts.statements.read_content);
  const Result<ContentRow> row = find_content_row(query, hash);
  if (!row) return fail(row.error());
  const Result<Coding> coding = coding_from(row->coding);
  if (!coding) return fail(coding.error());
  const ByteView kept = query.blob(3);
  if (query.is_null(4)) {  // of a schema without sums
    if (const auto bytes = expand_content(*parts.coder, *row, kept); !bytes) return fail(bytes.error());
  } else if (query.number(4) != content_sum(*row, kept)) {
    return fail(ErrorCode::corrupt, "its sum differs");
  }
  return StoredContent{*coding, row->size, Bytes(kept.begin(), kept.end())};
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
