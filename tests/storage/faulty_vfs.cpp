#include "tests/storage/faulty_vfs.hpp"

#include <sqlite3.h>

#include <map>
#include <utility>

namespace weft::storage {
namespace {

struct State {
  FaultyVfs::Fault fault = FaultyVfs::Fault::none;
  int writes_left = 0;
  int count = 0;
  std::map<const sqlite3_io_methods*, sqlite3_io_methods> patched;  // by the methods that they stand in for
  std::map<const sqlite3_io_methods*, const sqlite3_io_methods*> originals;
};
State state;  // C callbacks carry no context of their own

const std::string kName = "weft-faulty";

/// Returns what this write or sync comes to; SQLITE_OK: go on.
int strike() {
  ++state.count;
  if (state.fault == FaultyVfs::Fault::none) return SQLITE_OK;
  if (state.writes_left-- > 0) return SQLITE_OK;
  return state.fault == FaultyVfs::Fault::disk_full ? SQLITE_FULL : SQLITE_IOERR_WRITE;
}

const sqlite3_io_methods& original(sqlite3_file* file) {
  return *state.originals.at(file->pMethods);
}

int write_file(sqlite3_file* file, const void* data, int size, sqlite3_int64 offset) {
  if (const int failed = strike(); failed != SQLITE_OK) return failed;
  return original(file).xWrite(file, data, size, offset);
}

int sync_file(sqlite3_file* file, int flags) {
  if (const int failed = strike(); failed != SQLITE_OK) {
    return failed == SQLITE_FULL ? failed : SQLITE_IOERR_FSYNC;
  }
  return original(file).xSync(file, flags);
}

int open_file(sqlite3_vfs* vfs, const char* name, sqlite3_file* file, int flags, int* flags_out) {
  auto* const system = static_cast<sqlite3_vfs*>(vfs->pAppData);
  const int code = system->xOpen(system, name, file, flags, flags_out);
  if (code != SQLITE_OK || file->pMethods == nullptr) return code;
  auto [at, is_new] = state.patched.try_emplace(file->pMethods, *file->pMethods);
  if (is_new) {
    state.originals[&at->second] = file->pMethods;
    at->second.xWrite = write_file;
    at->second.xSync = sync_file;
  }
  file->pMethods = &at->second;
  return code;
}

}  // namespace

FaultyVfs::FaultyVfs() {
  static sqlite3_vfs layer;
  sqlite3_vfs* const system = sqlite3_vfs_find(nullptr);
  layer = *system;
  layer.zName = kName.c_str();
  layer.pAppData = system;
  layer.xOpen = open_file;
  sqlite3_vfs_register(&layer, 0);
  heal();
}

FaultyVfs::~FaultyVfs() {
  heal();
  sqlite3_vfs_unregister(sqlite3_vfs_find(kName.c_str()));
}

const std::string& FaultyVfs::name() const {
  return kName;
}

void FaultyVfs::fail_after(int writes, Fault fault) {
  state.writes_left = writes;
  state.fault = fault;
}

int FaultyVfs::take_count() {
  return std::exchange(state.count, 0);
}

}  // namespace weft::storage
