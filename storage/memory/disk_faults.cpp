#include "storage/memory/disk_faults.hpp"

namespace weft::storage {

std::optional<Error> DiskFaults::strike(const std::string& what) {
  std::optional<Error> error;
  if (full) {
    error = Error{ErrorCode::exhausted, what + ": the disk is full; free space, nothing was written"};
  } else if (tear_next) {
    tear_next = false;
    error = Error{ErrorCode::unavailable, what + ": the write broke off; nothing of it was kept"};
  } else if (fail_next > 0) {
    --fail_next;
    error = Error{fail_with, what + ": injected fault; nothing was written"};
  }
  if (error) ++struck;
  return error;
}

}  // namespace weft::storage
