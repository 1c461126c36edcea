#include "storage/lineage.hpp"

#include <algorithm>
#include <iterator>
#include <set>

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

std::vector<Lineage::Interval> Lineage::differing(const Lineage& other) const {
  // Between two neighbouring bounds every revision is in the same of the two.
  std::set<std::uint64_t> bounds;
  for (const auto* const intervals : {&intervals_, &other.intervals_}) {
    for (const Interval& interval : *intervals) bounds.insert({interval.first, interval.last + 1});
  }
  std::vector<Interval> differing;
  for (auto first = bounds.begin(); first != bounds.end(); ++first) {
    const auto end = std::next(first);
    if (end == bounds.end() || contains(*first) == other.contains(*first)) continue;
    if (!differing.empty() && differing.back().last + 1 == *first) {
      differing.back().last = *end - 1;
    } else {
      differing.push_back({*first, *end - 1});
    }
  }
  return differing;
}

}  // namespace weft::storage
