#pragma once
#include <optional>

#include "agents/methods/ceiling/config.hpp"
#include "agents/perception/birds_eye.hpp"
#include "agents/perception/camera_model.hpp"
#include "agents/perception/planar_motion.hpp"
#include "agents/perception/view.hpp"

namespace weft::agents {

/// Refers to two views of one camera, and where the ceiling is that they show.
struct CeilingViews {
  const CameraModel& camera;
  const Image& keyframe;
  const Image& now;
  double ceiling_m = 0.0;
};

struct SeenByFeatures {
  PlanarFit fit;
  std::size_t points = 0;  ///< that agree
};

/// Finds the motion by binary features of the rectified ceiling, however far the view has moved. None: too few
/// features agree.
std::optional<SeenByFeatures> see_ceiling_by_features(const CeilingViews& views, const BirdsEye& birds_eye,
                                                      const CeilingConfig& config, const AttitudePrior& prior,
                                                      const PlanarState& expected);

}  // namespace weft::agents
