#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "agents/methods/topometric/config.hpp"
#include "agents/methods/topometric/content.hpp"
#include "agents/perception/hamming.hpp"
#include "core/network/relation.hpp"

namespace weft::agents {

/// Pairs a point that two level places see, with the covariance of each.
struct SpacePair {
  Eigen::Vector3d in_a, in_b;
  Eigen::Matrix3d covariance_a, covariance_b;
};

/// Returns the matched features with what is known of where they are: their depth is uncertain along the ray.
std::vector<SpacePair> space_pairs(const RelateConfig& config, const TopometricContent& a, const TopometricContent& b,
                                   std::span<const Match> matches);

/// Returns the most sigmas by which the pair differs under a motion.
double sigmas_off(const SpacePair& pair, const Pose3& a_from_b);

/// Holds the motion that most pairs agree with, and which.
struct SpaceConsensus {
  Pose3 a_from_b;
  std::vector<std::size_t> inliers;
};
/// Finds it among those that two pairs leave open, as both frames are level: a turn about z and a way. Draws from a
/// fixed seed.
SpaceConsensus find_space_consensus(const RelateConfig& config, std::span<const SpacePair> pairs);

/// Holds the motion that fits the pairs best.
struct SpaceFit {
  Metric3 a_from_b;
  std::vector<std::size_t> inliers;
  double residual_m = 0.0;  ///< RMS of the inliers'
};
/// Fits the motion to the pairs by least squares, weighed by their covariances, and to what is known before. The
/// inliers are chosen anew as it moves. None: fewer than three are left.
std::optional<SpaceFit> fit_space_motion(const RelateConfig& config, std::span<const SpacePair> pairs,
                                         const SpaceConsensus& start, const Metric3& prior);

}  // namespace weft::agents
