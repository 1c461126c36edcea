#pragma once
#include <cstdint>

#include "core/time.hpp"

namespace weft::agents {

/// Limits a data rate as a token bucket: at most `bytes_per_second` on average, `burst_bytes` at once. Starts full.
class Budget {
 public:
  Budget(std::uint64_t bytes_per_second, std::uint64_t burst_bytes, SteadyTime now);

  /// Spends `bytes` and returns true if as many are saved up; more than the burst never are.
  bool take(std::uint64_t bytes, SteadyTime now);
  /// Returns when `bytes` (at most the burst) will be there, if nobody else takes any.
  SteadyTime when(std::uint64_t bytes) const;

 private:
  double bytes_per_second_;
  double burst_;
  double filled_;
  SteadyTime at_;
};

}  // namespace weft::agents
