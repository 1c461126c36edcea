#pragma once
#include <memory>
#include <vector>

#include "storage/memory/disk_faults.hpp"
#include "storage/spool.hpp"
#include "storage/spool/record.hpp"

namespace weft::storage {

/// Stands in for a robot's disk, in memory; outlives the spools that are opened on it.
struct SpoolDisk {
  DiskFaults faults;
  std::vector<SpoolRecord> records;  ///< oldest first
  Stops stops;
};

/// Makes a spool for tests and the simulation, with faults on demand.
std::unique_ptr<Spool> make_memory_spool(std::shared_ptr<SpoolDisk> disk);

}  // namespace weft::storage
