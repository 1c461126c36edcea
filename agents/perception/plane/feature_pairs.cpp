#include "agents/perception/plane/feature_pairs.hpp"

#include <cmath>

#include "agents/perception/lens.hpp"
#include "agents/perception/plane/geometry.hpp"

namespace weft::agents {
namespace {

/// Describes a feature in the undistorted image: its place there, from that on the mount's plane, and how many pixels
/// one metre on the plane is there (across the view: the finer direction).
struct InImage {
  Eigen::Vector2d normalised;
  double px_per_m = 0.0;
};

/// Puts features of one camera back into its image. Keeps the last height's homography: most are at one height.
class ToImage {
 public:
  explicit ToImage(const CameraModel& camera) : camera_(camera), here_(camera_from_floor(camera, Attitude{})) {}
  InImage operator()(const PlaneFeature& feature) {
    if (feature.above_floor_m != above_floor_m_) {
      above_floor_m_ = feature.above_floor_m;
      here_ = camera_from_plane(camera_, Attitude{}, above_floor_m_);
    }
    const Eigen::Vector3d ray = here_ * feature.on_plane.homogeneous();
    return {ray.hnormalized(), focal_px(camera_) / ray.z()};
  }

 private:
  const CameraModel& camera_;
  double above_floor_m_ = 0.0;
  Eigen::Matrix3d here_;
};

/// Gives a pair the height of both features, each by its certainty; what is certain needs no second opinion.
void set_height(const PlaneFeature& a, const PlaneFeature& b, PlanePair& pair) {
  const double variance_a = a.above_floor_sigma_m * a.above_floor_sigma_m;
  const double variance_b = b.above_floor_sigma_m * b.above_floor_sigma_m;
  const double both = variance_a + variance_b;
  const double share_of_b = both > 0.0 ? variance_a / both : 0.0;
  pair.above_floor_m = a.above_floor_m + share_of_b * (b.above_floor_m - a.above_floor_m);
  pair.above_floor_sigma_m = both > 0.0 ? std::sqrt(variance_a * variance_b / both) : 0.0;
}

}  // namespace

std::vector<PlanePair> feature_pairs(const MountedFeatures& a, const MountedFeatures& b,
                                     std::span<const Match> matches, double feature_sigma_m) {
  constexpr double image_sigma_px = 0.5;
  ToImage to_a(a.camera);
  ToImage to_b(b.camera);
  std::vector<PlanePair> pairs;
  for (const Match& m : matches) {
    const InImage at_a = to_a(a.features[m.a]);
    const InImage at_b = to_b(b.features[m.b]);
    // a's pixels reach b magnified by the ratio of the two scales.
    const double magnified = image_sigma_px * at_b.px_per_m / at_a.px_per_m;
    const double plane_px = std::sqrt(2.0) * feature_sigma_m * at_b.px_per_m;
    pairs.push_back({at_a.normalised, at_b.normalised,
                     std::sqrt(image_sigma_px * image_sigma_px + magnified * magnified + plane_px * plane_px)});
    set_height(a.features[m.a], b.features[m.b], pairs.back());
  }
  return pairs;
}

}  // namespace weft::agents
