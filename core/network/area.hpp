#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "core/ids.hpp"

namespace weft {

/// Says where on a floor plan a rule's spans were taken from, so that they can be taken anew.
struct Area {
  std::string plan;                        ///< under whose name the plan was registered
  ContentHash plan_hash{};                 ///< of that plan, as its registration has it
  std::vector<Eigen::Vector2d> corners{};  ///< in the plan's frame, metres; of a polygon, either way round
  bool operator==(const Area&) const = default;
};

inline constexpr std::size_t kLeastCorners = 3;  ///< of an area
inline constexpr std::size_t kMostCorners = 100;
inline constexpr double kLeastArea_m2 = 1e-4;

/// Says what is wrong with a polygon's corners, to follow on its name: "has 2 corners". Empty: nothing is, they are
/// as many as there may be, lie within `kPlanReach_m` and enclose something.
std::string problem_of(const std::vector<Eigen::Vector2d>& corners);

}  // namespace weft
