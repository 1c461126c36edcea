#include "agents/methods/topometric/space_features.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include "agents/perception/corner_tracks.hpp"
#include "agents/perception/scaled_descriptors.hpp"
#include "agents/perception/stereo/stereo_corners.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kColumns = 10;  // of the parts of a view
constexpr std::size_t kRows = 7;

/// Holds a corner with where it lies in the rectified left image.
struct DescribedCorner {
  Eigen::Vector3d in_camera;
  Eigen::Vector2d rectified;
  double depth_sigma_m = 0.0;
  Descriptor descriptor{};
};

std::vector<DescribedCorner> corners_in_depth(const PlaceConfig& config, const Rectifier& rectifier,
                                              const StereoPair& pair) {
  constexpr int window_px = 15;
  constexpr int levels = 3;
  constexpr double nearest_m = 0.4;
  const StereoRig& rig = rectifier.rig();
  const TrackingImage left = prepare_tracking(pair.left, window_px, levels);
  CornerConfig wanted;
  wanted.count = config.corners;
  wanted.columns = 16;
  wanted.rows = 8;
  StereoCornerBounds bounds;
  bounds.least_px = rig.disparity_px(config.feature_range_m);
  bounds.most_px = std::min(rig.disparity_px(nearest_m), 0.25 * rig.width);
  const std::vector<StereoCorner> both =
      in_both(rectifier, left, prepare_tracking(pair.right, window_px, levels), find_corners(left, wanted), bounds);
  std::vector<ScaledPoint> at;
  for (const StereoCorner& corner : both)
    at.push_back({rectifier.rectified_left(corner.taken), rig.focal_px * config.cell_m / corner.in_camera.z()});
  const std::vector<std::optional<Descriptor>> descriptors = describe_at_scale(rectifier.rectified(pair).left, at);
  std::vector<DescribedCorner> found;
  for (std::size_t i = 0; i < both.size(); ++i) {
    const double sigma_m = rig.depth_sigma_m(both[i].in_camera.z(), config.corner_sigma_px);
    if (descriptors[i] && sigma_m <= config.feature_sigma_m)
      found.push_back({both[i].in_camera, at[i].pixel, sigma_m, *descriptors[i]});
  }
  return found;
}

/// Returns the corners in the order in which they are wanted: the strongest of each part of the view, then the second
/// of each, and so on. What is strong in one view is so in the next; what is near, and so most certain, is soon out
/// of view.
std::vector<DescribedCorner> spread_by_part(const std::vector<DescribedCorner>& corners, const StereoRig& rig) {
  std::array<std::size_t, kColumns * kRows> taken{};
  std::vector<std::pair<std::size_t, std::size_t>> order;  // of its part, and which
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto part = [](double at, int size, std::size_t parts) {
      return std::min(parts - 1, static_cast<std::size_t>(std::max(0.0, at) * static_cast<double>(parts) / size));
    };
    const std::size_t cell = part(corners[i].rectified.y(), rig.height, kRows) * kColumns +
                             part(corners[i].rectified.x(), rig.width, kColumns);
    order.emplace_back(taken[cell]++, i);
  }
  std::sort(order.begin(), order.end());
  std::vector<DescribedCorner> spread;
  spread.reserve(corners.size());
  for (const auto& [rank, i] : order) spread.push_back(corners[i]);
  return spread;
}

}  // namespace

std::vector<SpaceFeature> space_features(const PlaceConfig& config, const Rectifier& rectifier,
                                         const StereoPair& pair, const Pose3& place_from_robot) {
  const StereoRig& rig = rectifier.rig();
  const Pose3 place_from_camera = place_from_robot * rig.robot_from_camera;
  std::vector<SpaceFeature> features;
  for (const DescribedCorner& corner : spread_by_part(corners_in_depth(config, rectifier, pair), rig)) {
    if (features.size() == static_cast<std::size_t>(config.features)) break;
    features.push_back({(place_from_camera * corner.in_camera).cast<float>(),
                        static_cast<float>(corner.depth_sigma_m), corner.descriptor});
  }
  return features;
}

}  // namespace weft::agents
