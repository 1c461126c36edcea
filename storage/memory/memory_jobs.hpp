#pragma once
#include <memory>

#include "storage/maintenance.hpp"
#include "storage/memory/memory_store.hpp"

/// Makes the jobs for the upkeep of a disk in memory, each in one step.
namespace weft::storage {

std::unique_ptr<StoreJob> make_memory_check(const MemoryDisk& disk);
/// Sets the floor at once; the rest is done in the step.
std::unique_ptr<StoreJob> make_memory_compaction(MemoryDisk& disk, Revision before);
std::unique_ptr<StoreJob> make_memory_stats(const MemoryDisk& disk);

}  // namespace weft::storage
