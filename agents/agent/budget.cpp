#include "agents/agent/budget.hpp"

#include <algorithm>

namespace weft::agents {

Budget::Budget(std::uint64_t bytes_per_second, std::uint64_t burst_bytes, SteadyTime now)
    : bytes_per_second_(static_cast<double>(bytes_per_second)),
      burst_(static_cast<double>(burst_bytes)),
      filled_(burst_),
      at_(now) {}

bool Budget::take(std::uint64_t bytes, SteadyTime now) {
  if (now > at_) {
    filled_ = std::min(burst_, filled_ + bytes_per_second_ * seconds(now - at_));
    at_ = now;
  }
  const auto wanted = static_cast<double>(bytes);
  if (wanted > filled_) return false;
  filled_ -= wanted;
  return true;
}

SteadyTime Budget::when(std::uint64_t bytes) const {
  const double lacking = static_cast<double>(bytes) - filled_;
  if (lacking <= 0.0) return at_;
  // One nanosecond more than the quotient, so that rounding never leaves the bucket a hair short.
  return at_ + from_seconds(lacking / bytes_per_second_) + Duration{1};
}

}  // namespace weft::agents
