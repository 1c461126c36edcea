#pragma once
#include "core/camera/camera_file.hpp"
#include "core/result.hpp"

namespace weft {

/// Checks a camera's lens. invalid: a coefficient is no number within +-1e6, or the lens is not monotone over its
/// image, so that two rays share a pixel: names how far from the optical centre, in pixels, rays begin to land nearer
/// again.
Result<void> check_lens(const CameraCalibration& camera);

}  // namespace weft
