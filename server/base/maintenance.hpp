#pragma once
#include <filesystem>
#include <memory>

#include "storage/map_store.hpp"

namespace weft::server {

/// Begins upkeep of the store, as `MapStore` describes it. None of it changes the map, so that parts of the server
/// which may do upkeep cannot commit.
class Maintenance {
 public:
  using Job = Result<std::unique_ptr<storage::StoreJob>>;

  explicit Maintenance(storage::MapStore& store) : store_(store) {}

  Job check() { return store_.check(); }
  Job snapshot_to(const std::filesystem::path& file) { return store_.snapshot_to(file); }
  Job verify(const std::filesystem::path& file, const Snapshot& live) { return store_.verify(file, live); }
  Job compact(Revision before) { return store_.compact(before); }
  Job stats() { return store_.stats(); }

 private:
  storage::MapStore& store_;
};

}  // namespace weft::server
