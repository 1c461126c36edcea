#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "storage/map_digest.hpp"
#include "storage/sqlite/restore.hpp"

namespace weft::storage::sqlite {

struct Verified {
  MapDigest restored;
  std::vector<std::string> findings;  ///< what is damaged, and what is another than in the live map
};

/// Restores a snapshot into FILE.verifying, loads it as a server would, and compares it with `live`. The folder is
/// gone when it returns; one that a killed process left in the same place as FILE goes first. `options`: what is told
/// and when it stops. exhausted: there is no room for a second one; unavailable: it was stopped, or a file cannot be
/// read or written; corrupt: it is no store.
Result<Verified> verify_snapshot(const std::filesystem::path& file, const Snapshot& live,
                                 const RestoreOptions& options);

}  // namespace weft::storage::sqlite
