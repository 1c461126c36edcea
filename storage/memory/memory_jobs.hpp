#pragma once
#include <memory>

#include "storage/maintenance.hpp"
#include "storage/memory/memory_store.hpp"

/// Upkeep of a disk in memory, each in one step.
namespace weft::storage {

std::unique_ptr<StoreJob> make_memory_check(const MemoryDisk& disk);
/// The floor is set at once, the rest is done in the step.
std::unique_ptr<StoreJob> make_memory_compaction(MemoryDisk& disk, Revision before);
std::unique_ptr<StoreJob> make_memory_stats(const MemoryDisk& disk);

}  // namespace weft::storage
