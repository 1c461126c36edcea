#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/result.hpp"

namespace weft::storage {

/// Tells how much space one kind of thing takes.
struct SpaceUse {
  std::string kind;  ///< "contents", "clouds", "places", "edges", "free pages", ...
  std::uint64_t count = 0;
  std::uint64_t disk_bytes = 0;
  std::uint64_t uncompressed_bytes = 0;  ///< as it was handed in; what is not compressed: the same as on disk
};

/// Tells how far a job is. `total` is an estimate and may change while commits go on.
struct JobProgress {
  std::uint64_t done = 0;
  std::uint64_t total = 0;
  std::string unit;  ///< of both, for people: "rows", "pages"
  bool finished = false;
  std::vector<std::string> findings;  ///< new ones since the last step, each naming its table and key
  std::string summary;                ///< when finished
  std::vector<SpaceUse> space;        ///< when a job of MapStore::stats has finished
};

/// Does upkeep of a store while it is used: commits and reads may come between two steps. Its store outlives it. A
/// job that is dropped before its end leaves nothing half done.
class StoreJob {
 public:
  virtual ~StoreJob() = default;
  /// Does a bounded piece of work, a few milliseconds. After an error, or when it has finished, the job does no more
  /// and gives the same answer again.
  virtual Result<JobProgress> step() = 0;
};

}  // namespace weft::storage
