#pragma once
#include <optional>

#include "agents/perception/stereo/unseen.hpp"
#include "agents/perception/view.hpp"

namespace weft::agents {

struct PairLightBounds {
  double least_light = 16.0;    ///< grey level that a twentieth of either image is brighter than
  double least_likeness = 0.2;  ///< of the range of grey levels in one image, of the other's
};

/// Returns why a pair shows too little to be matched: "too_dark" (both images), "covered" (one image is dark or shows
/// far less than the other); none: it may be matched. Both images are whole; every fourth pixel of every fourth row
/// is looked at.
std::optional<Unseen> too_little_light(const PairLightBounds& bounds, const StereoPair& pair);

}  // namespace weft::agents
