#include "agents/methods/floor/fallback.hpp"

#include <vector>

#include "agents/methods/floor/plane_bounds.hpp"
#include "agents/perception/attitude.hpp"
#include "agents/perception/direct_alignment.hpp"
#include "agents/perception/hamming.hpp"
#include "agents/perception/plane/geometry.hpp"
#include "agents/perception/plane/one_plane.hpp"

namespace weft::agents {
namespace {

struct Described {
  std::vector<Eigen::Vector2d> normalised;
  std::vector<Descriptor> descriptors;
};

Described described(const CameraModel& camera, const BirdsEye& birds_eye, const FloorConfig& c, const Image& image) {
  const Eigen::Matrix3d camera_from_level = camera_from_floor(camera, Attitude{});
  Described out;
  for (const PlaneFeature& feature : birds_eye.rectify(image, c.features, c.patch_metres_per_pixel).features) {
    out.normalised.push_back(apply(camera_from_level, feature.on_plane));
    out.descriptors.push_back(feature.descriptor);
  }
  return out;
}

}  // namespace

std::optional<SeenOtherwise> see_directly(const CameraModel& camera, const Image& keyframe, const Image& now,
                                          const AttitudePrior& prior, const PlanarState& expected) {
  std::optional<DirectFit> found = agreed_directly(camera, keyframe, now, prior, expected, {});
  if (!found) return std::nullopt;
  return SeenOtherwise{std::move(found->fit), found->points};
}

std::optional<SeenOtherwise> see_by_features(const CameraModel& camera, const BirdsEye& birds_eye,
                                             const FloorConfig& config, const Image& keyframe, const Image& now,
                                             const AttitudePrior& prior, const PlanarState& expected) {
  constexpr double sigma_px = 0.7;
  constexpr double threshold_px = 3.0;
  const Described a = described(camera, birds_eye, config, keyframe);
  const Described b = described(camera, birds_eye, config, now);
  std::vector<PlanePair> pairs;
  for (const Match& m : match_descriptors(a.descriptors, b.descriptors, {config.most_bits, config.ratio_unguided}))
    pairs.push_back({a.normalised[m.a], b.normalised[m.b], sigma_px});
  const OnePlane plane = one_plane(camera, one_plane_bounds(config), expected, pairs, threshold_px);
  if (!plane.refused.empty()) return std::nullopt;
  std::vector<PlanePair> agreeing;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (plane.is_on_it[i]) agreeing.push_back(pairs[i]);
  PlanarFit fit = fit_planar_motion(camera, camera, agreeing, prior, expected);
  if (!fit.converged) return std::nullopt;
  return SeenOtherwise{std::move(fit), agreeing.size()};
}

}  // namespace weft::agents
