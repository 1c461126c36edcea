#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "agents/perception/hamming.hpp"
#include "agents/perception/plane/feature.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

/// Bounds how far from a guess the truth may lie.
struct MatchGate {
  Pose2 a_from_b;
  double distance_m = 0.0;
  double heading_rad = 0.0;
};

/// Refers to features of one view, and where each lies in the robot's level frame.
struct LevelFeatures {
  std::span<const PlaneFeature> features;
  std::span<const Eigen::Vector2d> at;
};

/// Matches b's features with those of a near where the gate puts them, within `slack_m` more (guided matching, Gadd &
/// Newman, III-C); best first. Features farther than 20 m from their robot are left out.
std::vector<Match> guided_matches(const LevelFeatures& a, const LevelFeatures& b, const MatchGate& gate,
                                  const MatchBounds& bounds, double slack_m);

}  // namespace weft::agents
