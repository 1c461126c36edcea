#pragma once
#include <algorithm>
#include <vector>

#include "server/traffic/plan/berth_graph.hpp"

namespace weft::server {

/// Finds values by berth, whose numbers come by and by. References hold until a berth with a larger number is asked
/// for.
template <class Value>
class ByBerth {
 public:
  Value& at(Berth berth) {
    if (berth >= values_.size()) values_.resize(std::max<std::size_t>(2 * values_.size(), berth + std::size_t{64}));
    return values_[berth];
  }
  /// Returns null for a berth that nothing was put at, nor near.
  const Value* find(Berth berth) const { return berth < values_.size() ? &values_[berth] : nullptr; }
  void clear() { values_.clear(); }

 private:
  std::vector<Value> values_;
};

}  // namespace weft::server
