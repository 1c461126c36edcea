#include "server/fleet/reception.hpp"

#include <algorithm>

namespace weft::server {

void Reception::hear(std::uint64_t incarnation, std::uint64_t sequence, SteadyTime now) {
  if (incarnation != incarnation_) {
    *this = {};
    incarnation_ = incarnation;
    since_ = now;
  }
  if (now - since_ < kBegins) return;
  if (heard_ == 0) first_ = last_ = sequence;
  if (sequence < first_) return;  // was sent before counting began
  last_ = std::max(last_, sequence);
  ++heard_;
}

std::uint64_t Reception::missed() const {
  const std::uint64_t sent = heard_ == 0 ? 0 : last_ - first_ + 1;
  return sent > heard_ ? sent - heard_ : 0;
}

}  // namespace weft::server
