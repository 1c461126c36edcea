#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "agents/methods/floor/config.hpp"
#include "agents/perception/birds_eye.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

inline constexpr double kAnywhereM = std::numeric_limits<double>::infinity();

/// Describes the rigid motion by which a stretch of floor fits best on other floor of the same view. Where it fits
/// well, as on tiles, what is seen there has been seen in two places.
struct Repetition {
  Pose2 moved;               ///< the best such motion, in the robot's frame
  std::size_t agreeing = 0;  ///< features of the stretch that meet their like
  double spread = 0.0;       ///< of these, against that of the stretch, [0, about 1]: all over it, or in one corner
};

/// Sets the least motion, in metres, that counts as a repetition.
inline constexpr double kNoRepetitionM = 0.08;
/// Finds how the floor repeats itself. `at`: where each feature lies; `stretch`: indices. Moved by at least
/// kNoRepetitionM and at most `reach_m`; with a finite reach turned hardly at all, else by anything. Where fewer than
/// `fewest` can agree, as on most floors, it is not looked for: none.
Repetition find_repetition(const FloorConfig& c, const std::vector<FloorFeature>& features,
                           const std::vector<Eigen::Vector2d>& at, const std::vector<std::uint32_t>& stretch,
                           double reach_m, std::size_t fewest = 0);

}  // namespace weft::agents
