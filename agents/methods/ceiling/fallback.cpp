#include "agents/methods/ceiling/fallback.hpp"

#include "agents/methods/ceiling/rectified.hpp"
#include "agents/perception/plane/agreement.hpp"
#include "agents/perception/plane/consensus.hpp"
#include "agents/perception/plane/feature_pairs.hpp"
#include "agents/perception/plane/level_points.hpp"

namespace weft::agents {

std::optional<SeenByFeatures> see_ceiling_by_features(const CeilingViews& views, const BirdsEye& birds_eye,
                                                      const CeilingConfig& c, const AttitudePrior& prior,
                                                      const PlanarState& expected) {
  constexpr double patch_m = 0.2;  // a pixel of the patch, which nobody asks for
  const CameraModel& camera = views.camera;
  const std::vector<PlaneFeature> a = birds_eye.rectify(views.keyframe, c.features, patch_m).features;
  const std::vector<PlaneFeature> b = birds_eye.rectify(views.now, c.features, patch_m).features;
  const std::vector<Match> matches =
      match_descriptors(descriptors_of(a), descriptors_of(b), {c.most_bits, c.ratio_unguided});
  const auto fewest = static_cast<std::size_t>(c.fewest_inliers);
  if (matches.size() < fewest) return std::nullopt;
  const double pixel_m = metres_per_pixel(c, views.ceiling_m);
  const std::vector<Eigen::Vector2d> at_a = level_points(camera, expected.attitude_a, a);
  const std::vector<Eigen::Vector2d> at_b = level_points(camera, expected.attitude_b, b);
  const double within_m = c.consensus_px * pixel_m;
  const Consensus consensus = find_consensus(
      {.within_m = within_m, .hypotheses = c.hypotheses, .score = ConsensusScore::truncated}, matches, at_a, at_b);
  std::vector<std::size_t> agreeing;
  for (std::size_t i = 0; i < matches.size(); ++i)
    if ((consensus.a_from_b * at_b[matches[i].b] - at_a[matches[i].a]).norm() < within_m) agreeing.push_back(i);
  if (agreeing.size() < fewest) return std::nullopt;
  RefinedMotion refined =
      refine_motion({camera, camera}, feature_pairs({camera, a}, {camera, b}, matches, c.feature_sigma_px * pixel_m),
                    agreeing, prior, {consensus.a_from_b, expected.attitude_a, expected.attitude_b}, c.inlier_sigmas);
  if (!refined.fit.converged || refined.pairs.size() < fewest) return std::nullopt;
  return SeenByFeatures{std::move(refined.fit), refined.pairs.size()};
}

}  // namespace weft::agents
