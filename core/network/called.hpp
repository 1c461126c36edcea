#pragma once
#include <string>

#include "core/network/change.hpp"

namespace weft {

/// Returns what a batch's experience is called for people: its name with its id, or its id alone.
inline std::string called(const Batch& batch) {
  const std::string id = to_string(batch.experience);
  return batch.name.empty() ? id : batch.name + " (" + id + ")";
}

}  // namespace weft
