#pragma once
#include <cstddef>
#include <optional>

#include "clients/evaluate/ceiling/score.hpp"
#include "clients/evaluate/ceiling/way.hpp"
#include "core/random.hpp"
#include "core/result.hpp"

namespace weft::evaluate::ceiling {

/// Says how robots are put down.
struct PutDowns {
  std::size_t count = 200;
  double lamps_failed = 0.0;  ///< share of the lamps that are dark by then
};

/// Draws where a robot is put down: within half a metre of a line, headed anywhere.
Pose2 anywhere_on(const std::vector<agents::SitePoint>& line, Random& random);

/// Puts a robot of the same make, calibrated, down again and again, another day, that is told nothing but the map; it
/// stands for three views, which take a second. found_percent of it knew where it is within 0.10 m and 3 degrees;
/// wrong: it believed to be elsewhere. Each first view is related without a guess to the two nearest places and to
/// one far off as well (accepted, wrong_accepted, with the fixes), and each tenth is looked for by SIFT in the mosaic
/// (sift_percent, sift_wrong). None: stopped.
Result<std::optional<Measured>> measure_found(const Way& way, const Driven& driven, const PutDowns& put_downs,
                                              const Scenes& scenes);

}  // namespace weft::evaluate::ceiling
