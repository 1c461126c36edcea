#include "tests/crashes/power_vfs.hpp"

#include <sqlite3.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <map>
#include <vector>

#include "core/random.hpp"

namespace weft::crashes {
namespace {

constexpr sqlite3_int64 kSector = 512;
using Sector = std::array<std::uint8_t, kSector>;

/// Holds what a file was when it was last synchronised, as far as it has changed since.
struct Unsynced {
  sqlite3_int64 size = -1;  ///< -1: nothing has changed
  std::map<sqlite3_int64, Sector> sectors;
};

struct Layer {
  PowerPlan plan;
  std::uint64_t operations = 0;
  std::map<sqlite3_file*, Unsynced> files;
  std::map<const sqlite3_io_methods*, sqlite3_io_methods> patched;
  std::map<const sqlite3_io_methods*, const sqlite3_io_methods*> originals;
};
Layer layer;  // C callbacks carry no context of their own

const sqlite3_io_methods& original(sqlite3_file* file) {
  return *layer.originals.at(file->pMethods);
}

sqlite3_int64 size_of(sqlite3_file* file) {
  sqlite3_int64 size = 0;
  original(file).xFileSize(file, &size);
  return size;
}

/// Keeps the sectors of a stretch before they change.
void remember(sqlite3_file* file, sqlite3_int64 from, sqlite3_int64 to) {
  Unsynced& unsynced = layer.files[file];
  if (unsynced.size < 0) unsynced.size = size_of(file);
  for (sqlite3_int64 at = from / kSector * kSector; at < to; at += kSector) {
    if (unsynced.sectors.contains(at)) continue;
    Sector& before = unsynced.sectors[at];
    before.fill(0);
    original(file).xRead(file, before.data(), static_cast<int>(kSector), at);  // short at the end: zeros stay
  }
}

/// Loses the power: of the sectors not synced all, some or one go back to what they held before; ends the process.
[[noreturn]] void lose_power() {
  Random random(layer.plan.seed);
  const std::uint64_t mode = random.below(3);
  for (auto& [file, unsynced] : layer.files) {
    if (unsynced.size < 0) continue;
    const std::uint64_t only = unsynced.sectors.empty() ? 0 : random.below(unsynced.sectors.size());
    std::uint64_t number = 0;
    sqlite3_int64 kept_to = unsynced.size;
    for (const auto& [at, before] : unsynced.sectors) {
      const bool goes = mode == 0 || (mode == 1 ? random.chance(0.5) : number == only);
      ++number;
      if (goes) {
        original(file).xWrite(file, before.data(), static_cast<int>(kSector), at);
      } else {
        kept_to = std::max(kept_to, at + kSector);
      }
    }
    // The end of a file that grew goes where nothing of it was kept.
    if (size_of(file) > kept_to) original(file).xTruncate(file, kept_to);
  }
  ::_exit(0);
}

/// Counts an operation, at which the power may go; SQLITE_OK: go on.
int count_operation() {
  ++layer.operations;
  if (layer.operations >= layer.plan.after) lose_power();
  const bool is_full = layer.operations >= layer.plan.full_from && layer.operations < layer.plan.full_to;
  return is_full ? SQLITE_FULL : SQLITE_OK;
}

int write_file(sqlite3_file* file, const void* data, int size, sqlite3_int64 offset) {
  remember(file, offset, offset + size);
  if (const int failed = count_operation(); failed != SQLITE_OK) return failed;
  return original(file).xWrite(file, data, size, offset);
}

int truncate_file(sqlite3_file* file, sqlite3_int64 size) {
  remember(file, size, size_of(file));
  return original(file).xTruncate(file, size);
}

int sync_file(sqlite3_file* file, int flags) {
  if (const int failed = count_operation(); failed != SQLITE_OK) return failed;
  const int done = original(file).xSync(file, flags);
  if (done == SQLITE_OK) layer.files.erase(file);
  return done;
}

int close_file(sqlite3_file* file) {
  layer.files.erase(file);
  return original(file).xClose(file);
}

int open_file(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* flags_out) {
  auto* const system = static_cast<sqlite3_vfs*>(vfs->pAppData);
  const int code = system->xOpen(system, name, file, flags, flags_out);
  if (code != SQLITE_OK || file->pMethods == nullptr) return code;
  auto [at, is_new] = layer.patched.try_emplace(file->pMethods, *file->pMethods);
  if (is_new) {
    layer.originals[&at->second] = file->pMethods;
    at->second.xWrite = write_file;
    at->second.xTruncate = truncate_file;
    at->second.xSync = sync_file;
    at->second.xClose = close_file;
  }
  file->pMethods = &at->second;
  return code;
}

}  // namespace

std::string register_power_vfs(const PowerPlan& plan) {
  static const std::string kName = "weft-power";
  static sqlite3_vfs vfs;
  sqlite3_vfs* const system = sqlite3_vfs_find(nullptr);
  vfs = *system;
  vfs.zName = kName.c_str();
  vfs.pAppData = system;
  vfs.xOpen = open_file;
  sqlite3_vfs_register(&vfs, 0);
  layer.plan = plan;
  return kName;
}

}  // namespace weft::crashes
