#pragma once
#include <memory>
#include <vector>

#include "core/bytes.hpp"
#include "core/network/change.hpp"
#include "core/result.hpp"

namespace weft::storage {

/// A robot's own copy of what the server has not yet acknowledged; survives its crash.
class Spool {
 public:
  virtual ~Spool() = default;
  /// Durable when it returns. exhausted: disk full; nothing of it is there.
  virtual Result<void> append(const Batch& batch, const std::vector<Bytes>& contents) = 0;
  /// What is still to be acknowledged, oldest first; read at start.
  virtual Result<std::vector<Batch>> pending() const = 0;
  virtual Result<Bytes> content(const ContentHash& hash) const = 0;
  /// Forgets batches of the experience up to `through` and contents that no other batch needs.
  virtual Result<void> acknowledged(ExperienceId experience, std::uint64_t through) = 0;
};

}  // namespace weft::storage
