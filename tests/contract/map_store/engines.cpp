#include "tests/contract/map_store/engines.hpp"

#include "storage/memory/memory_store.hpp"
#include "storage/sqlite/sqlite_store.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::storage {
namespace {

class MemoryMedium final : public Medium {
 public:
  Result<std::unique_ptr<MapStore>> start() override { return make_memory_store(disk_); }
  Result<std::unique_ptr<MapStore>> start_beside() override { return make_memory_store(disk_); }

 private:
  std::shared_ptr<MemoryDisk> disk_ = std::make_shared<MemoryDisk>();
};

class SqliteMedium final : public Medium {
 public:
  Result<std::unique_ptr<MapStore>> start() override { return open_sqlite(directory_.path()); }
  Result<std::unique_ptr<MapStore>> start_beside() override {
    std::filesystem::remove(directory_.path() / "lock");  // as on a file system without locks
    return open_sqlite(directory_.path());
  }

 private:
  TemporaryDirectory directory_;
};

}  // namespace

std::unique_ptr<Medium> make_memory_medium() {
  return std::make_unique<MemoryMedium>();
}
std::unique_ptr<Medium> make_sqlite_medium() {
  return std::make_unique<SqliteMedium>();
}

}  // namespace weft::storage
