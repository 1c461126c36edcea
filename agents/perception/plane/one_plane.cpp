#include "agents/perception/plane/one_plane.hpp"

#include <algorithm>

#include "agents/perception/lens.hpp"
#include "agents/perception/plane/geometry.hpp"

namespace weft::agents {

OnePlane one_plane(const CameraModel& camera, const OnePlaneBounds& bounds, const PlanarState& expected,
                   const std::vector<PlanePair>& pairs, double threshold_px, double above_floor_m) {
  if (pairs.size() < bounds.fewest) return {"few_tracks", {}};
  std::vector<Eigen::Vector2d> a;
  std::vector<Eigen::Vector2d> b;
  for (const PlanePair& pair : pairs) {
    a.push_back(pair.in_a);
    b.push_back(pair.in_b);
  }
  const auto homography = robust_homography(a, b, threshold_px / focal_px(camera));
  if (!homography) return {"homography_refused", {}};
  if (homography->inliers < bounds.fewest ||
      static_cast<double>(homography->inliers) < bounds.fewest_share * static_cast<double>(pairs.size()))
    return {"few_tracks", {}};

  const std::vector<PlaneMotion> candidates = decompose(homography->b_from_a);
  double motion = 0.0;
  for (const PlaneMotion& candidate : candidates) motion = std::max(motion, candidate.translation_in_heights.norm());
  if (motion >= bounds.decompose_from_heights) {
    const PlaneAway plane = plane_away(camera, expected.attitude_a, above_floor_m);
    const Decomposed chosen = choose(candidates, plane.normal_in_camera, bounds.motion);
    if (!chosen.motion) return {"normal_refused", {}};
  }
  return {{}, homography->inlier};
}

}  // namespace weft::agents
