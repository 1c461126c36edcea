#pragma once
#include "core/result.hpp"
#include "storage/map_store.hpp"
#include "storage/sqlite/database.hpp"

namespace weft::storage::sqlite {

/// Reads everything but contents. Damaged rows are left out and named; an error only when a table cannot be read.
Result<Stored> load(const Database& database, Epoch epoch, Revision revision);

}  // namespace weft::storage::sqlite
