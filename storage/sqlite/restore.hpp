#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "core/ids.hpp"
#include "core/result.hpp"
#include "storage/sqlite/sqlite_store.hpp"

namespace weft::storage {

struct RestoreProgress {
  std::string stage;  ///< "copy", "look at pages", "check", "replace"
  std::uint64_t done = 0;
  std::uint64_t total = 0;
  std::string unit;
};

struct RestoreOptions {
  bool accept_damage = false;  ///< restore a snapshot in which the check finds damage: what is sound is served
  std::function<void(const RestoreProgress&)> progress{};
  std::function<bool()> stops{};  ///< asked often; once it says true nothing is replaced: unavailable
};

struct Restored {
  Revision revision;
  Epoch epoch;                        ///< the next server's is one more
  std::filesystem::path kept_aside;   ///< the database that was replaced; empty: there was none
  std::vector<std::string> findings;  ///< what is damaged in the snapshot, accepted
};

/// Makes a snapshot file the map of a store's directory, offline. The snapshot is copied and checked whole before
/// anything is replaced; a crash at any moment leaves the old map or the new one. Its epoch is above both, so that
/// agents follow. unavailable: a server has the directory open, or the files cannot be read or written. corrupt: the
/// snapshot is no store or damaged. newer: from a newer schema. exhausted: the disk is full.
Result<Restored> restore(const std::filesystem::path& snapshot, const std::filesystem::path& directory,
                         const RestoreOptions& options = {});

}  // namespace weft::storage
