#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "agents/perception/hamming.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

/// Names what the best motion has most of.
enum class ConsensusScore {
  count,     ///< matches that agree
  truncated  ///< least sum of squared distances, none counted for more than the bound (MSAC, Torr & Zisserman 2000)
};

struct ConsensusBounds {
  double within_m = 0.022;        ///< a match agrees that is off by less
  int hypotheses = 600;           ///< drawn at most
  double shortest_base_m = 0.15;  ///< between the two points that a motion is made of
  ConsensusScore score = ConsensusScore::count;
};

struct Consensus {
  Pose2 a_from_b;
  std::size_t count = 0;
};

/// Finds the rigid planar motion that most matches agree with: pairs are drawn from a growing set of the best ones
/// (the order of PROSAC, Chum & Matas 2005). Draws from a fixed seed: equal contents give equal answers.
Consensus find_consensus(const ConsensusBounds& bounds, const std::vector<Match>& matches,
                         const std::vector<Eigen::Vector2d>& at_a, const std::vector<Eigen::Vector2d>& at_b);

/// Measures the area that points cover, in m2: the root of the determinant of their covariance; 0 of fewer than 3.
double area_of(const std::vector<Eigen::Vector2d>& points);

}  // namespace weft::agents
