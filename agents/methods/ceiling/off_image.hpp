#pragma once
#include <cmath>

#include "agents/perception/lens.hpp"
#include "agents/perception/lens_slope.hpp"
#include "agents/perception/planar_motion.hpp"

namespace weft::agents {

/// Says how far pairs are off what a motion has them, in pixels of b's view itself.
class OffImage {
 public:
  OffImage(const CameraModel& camera, const PlanarState& state)
      : camera_(camera), reproject_(camera, camera, state) {}

  double px(const PlanePair& pair) const {
    const Reprojection there = reproject_(pair);
    return there.in_front ? off(pair, there).norm() : kNoWay;
  }
  /// Returns the same across the epipolar direction, where no height explains it.
  double across_px(const PlanePair& pair) const {
    const Reprojection there = reproject_(pair);
    if (!there.in_front) return kNoWay;
    const Eigen::Vector2d along = pixels_by_normalised(camera_, there.in_b) * there.by_height;
    const Eigen::Vector2d all = off(pair, there);
    if (along.norm() < 1e-9) return all.norm();
    return std::abs(along.x() * all.y() - along.y() * all.x()) / along.norm();
  }

 private:
  static constexpr double kNoWay = 1e6;
  Eigen::Vector2d off(const PlanePair& pair, const Reprojection& there) const {
    return pixel_from_normalised(camera_, pair.in_b) - pixel_from_normalised(camera_, there.in_b);
  }
  const CameraModel& camera_;
  Reprojector reproject_;
};

}  // namespace weft::agents
