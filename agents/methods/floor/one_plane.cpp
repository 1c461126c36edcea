#include "agents/methods/floor/one_plane.hpp"

#include <algorithm>

#include "agents/perception/homography.hpp"
#include "agents/perception/lens.hpp"

namespace weft::agents {

OnePlane one_plane(const CameraModel& camera, const FloorConfig& c, const PlanarState& expected,
                   const std::vector<FloorPair>& pairs, double threshold_px) {
  const auto fewest = static_cast<std::size_t>(c.fewest_tracks);
  if (pairs.size() < fewest) return {"few_tracks", {}};
  std::vector<Eigen::Vector2d> a;
  std::vector<Eigen::Vector2d> b;
  for (const FloorPair& pair : pairs) {
    a.push_back(pair.in_a);
    b.push_back(pair.in_b);
  }
  const auto homography = robust_homography(a, b, threshold_px / focal_px(camera));
  if (!homography) return {"homography_refused", {}};
  if (homography->inliers < fewest ||
      static_cast<double>(homography->inliers) < c.fewest_tracks_share * static_cast<double>(pairs.size()))
    return {"few_tracks", {}};

  const std::vector<PlaneMotion> candidates = decompose(homography->b_from_a);
  double motion = 0.0;
  for (const PlaneMotion& candidate : candidates) motion = std::max(motion, candidate.translation_in_heights.norm());
  if (motion >= c.decompose_from_heights) {
    const FloorPlane plane = floor_plane(camera, expected.attitude_a);
    const Decomposed chosen =
        choose(candidates, plane.normal_in_camera, {c.normal_angle_rad, c.along_normal_heights});
    if (!chosen.motion) return {"normal_refused", {}};
  }
  return {{}, homography->inlier};
}

}  // namespace weft::agents
