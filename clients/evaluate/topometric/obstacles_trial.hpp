#pragma once
#include <optional>

#include "clients/evaluate/topometric/scenes.hpp"
#include "clients/evaluate/topometric/score.hpp"
#include "clients/evaluate/topometric/taught.hpp"

namespace weft::evaluate::topometric {

/// Says how much is in the way.
struct InTheWay {
  double metres = 12.5;  ///< of the hall's line, taught and driven
  std::size_t crates = 3;
  std::size_t walkers = 2;
};

/// Teaches r1 some of the hall's line; the next day it drives there past crates that were not there, one of them 0.15
/// m high, and persons who walk. Values: contacts, clearance_m (the least), reached_percent. None: stopped.
Result<std::optional<Measured>> measure_obstacles(const Scenes& scenes, const Driven& driven, const InTheWay& what);

/// Sends r1 along a corridor of level11, as it was taught, that is closed on the next day. Values: told_s (from when
/// it came within 1.5 m of what closes it, until it is said to be blocked), went_round (it had another way, and took
/// it), contacts, clearance_m. None: stopped.
Result<std::optional<Measured>> measure_blocked(const agents::sim::Site& site, const Driven& driven,
                                                const Taught& taught);

}  // namespace weft::evaluate::topometric
