#pragma once
#include "agents/methods/method.hpp"

namespace weft::agents {

/// Says how the robot is driven by its method.
struct Manner {
  bool by_places = false;  ///< its method finds its way among the released places; else it is steered along a path
  bool both_ways = false;  ///< routes lead against the direction that was taught, too
};

template <Method M>
constexpr Manner manner_of() {
  return {.by_places = SteersItself<M> && !steers_along_a_path<M>(), .both_ways = drives_both_ways<M>()};
}

}  // namespace weft::agents
