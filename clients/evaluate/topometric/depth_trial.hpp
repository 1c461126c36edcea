#pragma once
#include <optional>

#include "clients/evaluate/topometric/scenes.hpp"
#include "clients/evaluate/topometric/score.hpp"

namespace weft::evaluate::topometric {

/// Leads a pair through level11 past plain walls and through the hall, and compares what is matched densely with how
/// far away the site truly is at each pixel, by rays that the judge casts itself. The mount is taken to be as it is
/// given, which the judge has to know; lenses and baseline are off as ever. Values: dense_wrong_percent (of what is
/// returned on level11, off by more than 1 px), dense_percent, hall_dense_percent, hall_wrong_percent. None: stopped.
Result<std::optional<Measured>> measure_depth(const Scenes& scenes, const Driven& driven);

}  // namespace weft::evaluate::topometric
