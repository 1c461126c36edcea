#pragma once
#include <filesystem>
#include <memory>

#include "storage/maintenance.hpp"
#include "storage/sqlite/parts.hpp"

/// Makes the upkeep jobs of storage/map_store.hpp, each in a file of its own. `parts` outlives the job.
namespace weft::storage::sqlite {

Result<std::unique_ptr<StoreJob>> make_check(Parts& parts);
Result<std::unique_ptr<StoreJob>> make_snapshot(Parts& parts, const std::filesystem::path& file);
Result<std::unique_ptr<StoreJob>> make_verification(const std::filesystem::path& file, const Snapshot& live);
Result<std::unique_ptr<StoreJob>> make_compaction(Parts& parts, Revision before);
Result<std::unique_ptr<StoreJob>> make_stats(const Parts& parts);

}  // namespace weft::storage::sqlite
