#pragma once
#include <cstdint>

#include "core/result.hpp"
#include "storage/sqlite/database.hpp"

namespace weft::storage::sqlite {

/// Marks the file's header with "Weft", so that a store is told from any other SQLite file.
inline constexpr std::uint32_t kApplicationId = 0x57656674;

/// Returns the version that this software writes; it reads all from 1 on by migrating them.
std::uint64_t schema_version();

/// Makes an empty file a store, or brings an older store up to date, in one transaction; then sets WAL and full
/// synchronisation. corrupt: another program's file. newer: from a newer schema; the message names both versions.
Result<void> prepare_schema(const Database& database, const std::filesystem::path& file);

}  // namespace weft::storage::sqlite
