#include "agents/methods/ceiling/same_scale.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents {

SharedCeiling shared_ceiling(const CeilingContent& a, const CeilingContent& b) {
  const double variance_a = a.ceiling_sigma_m * a.ceiling_sigma_m;
  const double variance_b = b.ceiling_sigma_m * b.ceiling_sigma_m;
  const double share_of_b = variance_a / (variance_a + variance_b);
  // The better one's sigma: what both were told may be the same.
  return {a.ceiling_m + share_of_b * (b.ceiling_m - a.ceiling_m), std::min(a.ceiling_sigma_m, b.ceiling_sigma_m),
          std::abs(a.ceiling_m - b.ceiling_m) / std::sqrt(variance_a + variance_b)};
}

CeilingContent at_ceiling(const CeilingContent& content, double ceiling_m) {
  CeilingContent scaled = content;
  if (ceiling_m == content.ceiling_m) return scaled;
  const Eigen::Vector3d& eye = content.camera.robot_from_camera.translation;
  const double factor = (ceiling_m - eye.z()) / (content.ceiling_m - eye.z());
  scaled.ceiling_m = ceiling_m;
  for (PlaneFeature& feature : scaled.features) {
    feature.on_plane = eye.head<2>() + factor * (feature.on_plane - eye.head<2>());
    feature.above_floor_m = eye.z() + factor * (feature.above_floor_m - eye.z());
    feature.above_floor_sigma_m *= factor;
  }
  return scaled;
}

}  // namespace weft::agents
