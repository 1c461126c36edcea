#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "agents/perception/plane/consensus.hpp"
#include "agents/perception/plane/feature.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

inline constexpr double kAnywhereM = std::numeric_limits<double>::infinity();

/// Describes the rigid motion by which a stretch of a plane fits best on another of the same view. Where it
/// fits well, as on tiles, what is seen there has been seen in two places.
struct Repetition {
  Pose2 moved;               ///< the best such motion, in the robot's frame
  std::size_t agreeing = 0;  ///< features of the stretch that meet their like
  double spread = 0.0;       ///< of these, against that of the stretch, [0, about 1]: all over it, or in one corner
};

struct RepetitionBounds {
  ConsensusBounds consensus;
  int most_bits = 80;     ///< of 256 between descriptors that are alike
  double least_m = 0.08;  ///< a motion that is shorter is none
};

/// Finds how a plane repeats itself. `at`: where each feature lies; `stretch`: indices. Moved by at least
/// `least_m` and at most `reach_m`; with a finite reach turned hardly at all, else by anything. Where fewer than
/// `fewest` can agree, as on most planes, it is not looked for: none.
Repetition find_repetition(const RepetitionBounds& bounds, const std::vector<PlaneFeature>& features,
                           const std::vector<Eigen::Vector2d>& at, const std::vector<std::uint32_t>& stretch,
                           double reach_m, std::size_t fewest = 0);

/// Returns the share of the features that have a twin in the same view, [0, 1]: another one at least `least_m` away
/// whose descriptor differs by at most `most_bits` of 256. No motion need explain the twins. 0 of no features.
double share_with_twins(const std::vector<PlaneFeature>& features, const std::vector<Eigen::Vector2d>& at,
                        int most_bits, double least_m);

}  // namespace weft::agents
