#pragma once
#include "agents/perception/camera_model.hpp"
#include "core/camera/camera_file.hpp"

namespace weft::evaluate::floor {

/// A camera and how well it is known.
struct KnownCamera {
  agents::CameraModel model;
  CalibrationSigma sigma;
};

}  // namespace weft::evaluate::floor
