#pragma once
#include "storage/map_store.hpp"
#include "storage/plan.hpp"
#include "storage/sqlite/rows.hpp"
#include "storage/sqlite/statements.hpp"

namespace weft::storage::sqlite {

/// Holds the one row of table `store`.
struct StoreRow {
  Epoch epoch;
  Revision revision;
  std::uint64_t contents = 0;
  std::uint64_t content_bytes = 0;
  Revision floor;  ///< the oldest that is kept; 0: all are
};
Result<StoreRow> read_store_row(const Statements& statements);
Result<void> write_store_row(const Statements& statements, const StoreRow& row);

/// Reads the facts that are stored of what a transaction needs.
Result<Facts> read_facts(const Statements& statements, const Needs& needs);

/// Writes what the plan calls fresh, within the caller's transaction; returns the store's row as it has then become.
Result<StoreRow> write_changes(const Statements& statements, ContentCoder& coder, const Transaction& transaction,
                               const Plan& plan, StoreRow row);

}  // namespace weft::storage::sqlite
