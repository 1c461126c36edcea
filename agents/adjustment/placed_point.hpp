#pragma once
#include "agents/adjustment/window.hpp"

namespace weft::agents {

/// Returns the point where all who saw it see it, as the places stand: least squares over the three coordinates with
/// the height's prior and Huber's loss, and the height's sigma as the rays have it. One that was seen from a single
/// place stays on its ray, near the ceiling's height.
MosaicPoint placed(const Mosaic& mosaic, const MosaicIndex& index, std::uint32_t point);

}  // namespace weft::agents
