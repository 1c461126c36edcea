#pragma once
#include <filesystem>
#include <memory>
#include <set>
#include <string>

#include "storage/sqlite/directory_lock.hpp"
#include "storage/sqlite/rows.hpp"
#include "storage/sqlite/statements.hpp"
#include "storage/sqlite/writer.hpp"

namespace weft::storage::sqlite {

/// Holds the parts that stand open while a store is used; its jobs work on the same. Members go in reverse:
/// statements before the database before the lock.
struct Parts {
  std::filesystem::path directory;
  std::string vfs;
  DirectoryLock lock;
  Database database;
  Statements statements;
  Epoch epoch{};
  std::unique_ptr<ContentCoder> coder = std::make_unique<ContentCoder>();
  StoreRow row{};                       ///< as last committed
  std::set<ContentHash> quarantined{};  ///< found damaged by this process
  std::uint64_t moves = 0;              ///< counts commits that took something out or back
  std::weak_ptr<std::set<ContentHash>>
      used_meanwhile{};  ///< a compaction that is under way notes here what commits name
};

/// Reads the store's row, for a write transaction. stale: another server has opened the store since.
Result<StoreRow> current_row(const Parts& parts);

/// Decodes a content. corrupt: the bytes do not decode to what the row says, by the SHA-256 too.
Result<Bytes> expand_content(ContentCoder& coder, const ContentRow& row, ByteView kept);
/// Reads a content. not_found; corrupt: quarantined before, or its bytes do not decode to what the hash says.
Result<Bytes> read_content(const Parts& parts, const ContentHash& hash);
/// Reads it as it is kept. corrupt: quarantined before, or its sum differs; without a sum it is decoded.
Result<StoredContent> read_stored(const Parts& parts, const ContentHash& hash);

/// Marks the row, so that it stays named after a restart. When the disk takes no mark, this process remembers.
void quarantine(Parts& parts, const ContentHash& hash);

}  // namespace weft::storage::sqlite
