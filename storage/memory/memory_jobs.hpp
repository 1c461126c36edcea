#pragma once
#include <memory>

#include "storage/maintenance.hpp"
#include "storage/memory/memory_store.hpp"

/// Upkeep of a disk in memory, each in one step.
namespace weft::storage {

std::unique_ptr<StoreJob> make_memory_check(const MemoryDisk& disk);

}  // namespace weft::storage
