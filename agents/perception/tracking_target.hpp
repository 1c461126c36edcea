#pragma once
#include "agents/perception/corner_tracks.hpp"

namespace weft::agents {

/// Prepares an image as prepare_tracking does, but for finding corners and being tracked into only, which takes less
/// time: what is tracked from needs its gradients as well.
TrackingImage prepare_target(const Image& image, int window_px, int levels);
/// Returns the image prepared for being tracked from as well.
TrackingImage with_gradients(const TrackingImage& image);

}  // namespace weft::agents
