#pragma once
#include <optional>

#include "clients/evaluate/topometric/scenes.hpp"
#include "clients/evaluate/topometric/score.hpp"

namespace weft::evaluate::topometric {

/// Has r1 and then r2, which is told nothing, taught stretches of level11 that overlap. Values: joined, stitches,
/// wrong, stitch_m, stitch_deg. None: stopped.
struct Overlap {
  double first_to_m = 40.0;  ///< r1 is taught from the beginning to here,
  double second_from_m = 12.0;
  double second_to_m = 52.0;
};
Result<std::optional<Measured>> measure_merge(const Scenes& scenes, const Driven& driven, const Overlap& overlap);

/// Has r1 taught two of the aisles, r2 the two others, which look alike and never meet: each stitch between them is
/// wrong, as is one from an aisle of a run to another. Values: stitches, wrong. None: stopped.
Result<std::optional<Measured>> measure_aliasing(const Scenes& scenes, const Driven& driven);

}  // namespace weft::evaluate::topometric
