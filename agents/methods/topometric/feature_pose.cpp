#include "agents/methods/topometric/feature_pose.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "agents/methods/topometric/level_relation.hpp"
#include "agents/methods/topometric/space_consensus.hpp"
#include "agents/perception/hamming.hpp"
#include "agents/perception/plane/consensus.hpp"

namespace weft::agents {
namespace {

constexpr double kPairWithinM = 0.12;  // of each other in space, once moved
constexpr int kPoseHypotheses = 200;

/// Holds features by number, as matching and the consensus take them.
struct SeenFromAbove {
  explicit SeenFromAbove(const TopometricContent& content) {
    for (const SpaceFeature& feature : content.features) {
      descriptors.push_back(feature.descriptor);
      at.push_back(feature.in_place.head<2>().cast<double>());
    }
  }
  std::vector<Descriptor> descriptors;
  std::vector<Eigen::Vector2d> at;
};

}  // namespace

std::optional<FeaturePose> pose_by_features(const RelateConfig& config, const TopometricContent& place,
                                            const TopometricContent& seen) {
  const SeenFromAbove of_place(place);
  const SeenFromAbove of_seen(seen);
  std::vector<Match> matches =
      match_descriptors(of_place.descriptors, of_seen.descriptors, {config.most_bits, config.ratio});
  std::erase_if(matches, [&](const Match& match) {
    const float apart = place.features[match.a].in_place.z() - seen.features[match.b].in_place.z();
    return std::abs(static_cast<double>(apart)) > kPairWithinM;
  });
  const auto fewest = static_cast<std::size_t>(
      std::max<double>(config.fewest_guided, config.fewest_inliers_share * static_cast<double>(matches.size())));
  if (matches.size() < fewest) return std::nullopt;
  ConsensusBounds bounds;
  bounds.within_m = kPairWithinM;
  bounds.hypotheses = kPoseHypotheses;
  bounds.shortest_base_m = 0.4;
  bounds.score = ConsensusScore::truncated;
  const Consensus found = find_consensus(bounds, matches, of_place.at, of_seen.at);
  SpaceConsensus start{lift(found.a_from_b), {}};
  for (std::size_t i = 0; i < matches.size(); ++i)
    if ((found.a_from_b * of_seen.at[matches[i].b] - of_place.at[matches[i].a]).norm() < kPairWithinM)
      start.inliers.push_back(i);
  if (start.inliers.size() < fewest) return std::nullopt;
  const std::optional<SpaceFit> fit = fit_space_motion(config, space_pairs(config, place, seen, matches), start,
                                                       level_prior_about(config, place, seen, start.a_from_b));
  if (!fit || fit->inliers.size() < fewest) return std::nullopt;
  return FeaturePose{planar(fit->a_from_b), planar_covariance(fit->a_from_b),
                     static_cast<std::uint32_t>(fit->inliers.size())};
}

}  // namespace weft::agents
