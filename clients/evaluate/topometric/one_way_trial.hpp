#pragma once
#include <optional>

#include "clients/evaluate/topometric/scenes.hpp"
#include "clients/evaluate/topometric/score.hpp"

namespace weft::evaluate::topometric {

/// Teaches r1 the first 26 m of level11, one way; the next day it drives there and back. Values of the way there by
/// the names of add_located, of the way back with "back_" before them; reached_percent. None: stopped.
Result<std::optional<Measured>> measure_one_way(const Scenes& scenes, const Driven& driven);

/// Teaches r1 the same 26 m; the next day r2, whose pair and wheels err otherwise, drives there by that map. Values
/// by the names of add_located and add_deliveries. None: stopped.
Result<std::optional<Measured>> measure_other_robot(const Scenes& scenes, const Driven& driven);

/// Teaches r1 the S of the hall; the next day it is sent from its beginning to its end. Values: driven_share (of the
/// way that was taught), arrived. `from_m`, `to_m`: the stretch of the line that is taught. None: stopped.
Result<std::optional<Measured>> measure_shortcut(const Scenes& scenes, const Driven& driven, double from_m,
                                                 double to_m);

}  // namespace weft::evaluate::topometric
