#pragma once
#include <cstdint>
#include <optional>
#include <string>

#include "core/result.hpp"

namespace weft::storage {

/// Describes faults that a test or the simulation plays on a disk in memory. A write that one strikes leaves nothing.
struct DiskFaults {
  std::uint32_t fail_next = 0;                   ///< the next N commits or appends fail
  ErrorCode fail_with = ErrorCode::unavailable;  ///< with this code: exhausted | unavailable
  bool full = false;         ///< every write, opening a store too, fails with exhausted until set back
  bool tear_next = false;    ///< the next write breaks off half way: unavailable, and recovery finds nothing of it
  std::uint64_t struck = 0;  ///< writes that failed so far

  /// Returns the failure of this write, if one is due; `what` names the disk for the message.
  std::optional<Error> strike(const std::string& what);
};

}  // namespace weft::storage
