#include "storage/lineage.hpp"

#include <algorithm>

namespace weft::storage {

Lineage::Lineage(Revision top, const std::map<Revision, Revision>& bases) {
  while (top.value > 0) {
    auto jump = bases.upper_bound(top);
    const bool has_jumped = jump != bases.begin();
    if (has_jumped) --jump;
    intervals_.push_back({has_jumped ? jump->first.value : 1, top.value});
    top = has_jumped ? jump->second : Revision{};
  }
}

bool Lineage::contains(std::uint64_t revision) const {
  return std::ranges::any_of(
      intervals_, [&](const Interval& interval) { return interval.first <= revision && revision <= interval.last; });
}

}  // namespace weft::storage
