#include "agents/perception/lens_slope.hpp"

#include "agents/perception/lens.hpp"

namespace weft::agents {

Eigen::Matrix2d pixels_by_normalised(const CameraModel& camera, const Eigen::Vector2d& normalised) {
  constexpr double step = 1e-4;  // the error of central differences is far below what a weight needs
  Eigen::Matrix2d slope;
  for (int k = 0; k < 2; ++k) {
    const Eigen::Vector2d aside = step * Eigen::Vector2d::Unit(k);
    slope.col(k) =
        pixel_from_normalised(camera, normalised + aside) - pixel_from_normalised(camera, normalised - aside);
  }
  return slope / (2.0 * step * focal_px(camera));
}

}  // namespace weft::agents
