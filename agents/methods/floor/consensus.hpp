#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "agents/methods/floor/config.hpp"
#include "agents/perception/hamming.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

struct Consensus {
  Pose2 a_from_b;
  std::size_t count = 0;
};

/// The rigid planar motion that most matches agree with: pairs are drawn from a growing set of the best ones (the
/// order of PROSAC, Chum & Matas 2005). Drawn from a fixed seed: equal contents give equal answers.
Consensus find_consensus(const FloorConfig& c, const std::vector<Match>& matches,
                         const std::vector<Eigen::Vector2d>& at_a, const std::vector<Eigen::Vector2d>& at_b);

/// A measure of the area that points take: the root of the determinant of their scatter.
double area_of(const std::vector<Eigen::Vector2d>& points);

}  // namespace weft::agents
