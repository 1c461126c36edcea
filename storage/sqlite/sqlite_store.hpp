#pragma once
#include <filesystem>
#include <memory>
#include <string>

#include "storage/map_store.hpp"

namespace weft::storage {

struct SqliteOptions {
  std::string vfs{};  ///< SQLite's file layer by name; empty: the system's. Tests bring one with faults.
  /// Has a thread of the store's own empty its log, so that no commit waits for that. Without: one in some commits
  /// does.
  bool empties_log_aside = false;
};

/// Opens the map store in `directory` (made if need be), file map.sqlite; its format is docs/formats/store.md.
/// unavailable: another process has it open, or it cannot be read or written. corrupt: not a map store of Weft.
/// newer: from a newer schema.
Result<std::unique_ptr<MapStore>> open_sqlite(const std::filesystem::path& directory,
                                              const SqliteOptions& options = {});

}  // namespace weft::storage
