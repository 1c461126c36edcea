#pragma once
#include <optional>
#include <span>

#include "agents/methods/ceiling/height.hpp"

namespace weft::agents {

/// Says what else is known of a motion's scale than heights.
struct KnownScale {
  double factor = 1.0;       ///< by which the motion would have to be multiplied
  double sigma_share = 1e6;  ///< 1 sigma of its logarithm
  bool is_held = false;      ///< heights that were told before hold it: it is changed on strong evidence only
};

/// Returns by what a motion is to be multiplied so that heights are those of things on a ceiling and below it, and
/// none above: the likeliest of what lies within a factor of 1.4, by the heights that the motion has told and by what
/// else is known. 1 where too few heights are told, and where what is held is not clearly wrong.
double gauge_factor(std::span<const ToldHeight> heights, const HeightPrior& prior, double camera_m,
                    const KnownScale& known);

}  // namespace weft::agents
