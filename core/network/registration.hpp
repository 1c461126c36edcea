#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/ids.hpp"

namespace weft {

/// Says where a point of a place was found on a floor plan.
struct Pick {
  std::string name;  ///< for people: the label by which the place was named, or its id
  PlaceId place;
  Eigen::Vector2d in_place = Eigen::Vector2d::Zero();  ///< the point in the place's frame, metres
  Eigen::Vector2d on_plan = Eigen::Vector2d::Zero();   ///< the same point on the plan, metres
  double sigma_m = 0.05;                               ///< [0.001, 10] of the point on the plan, each way
  std::optional<double> heading{};                     ///< of the place on the plan, radians
  bool operator==(const Pick&) const = default;
};

/// Registers a floor plan to the map. Where places lie on the plan is worked out anew for every map
/// (core/network/site_solver.hpp), never stored, and nobody navigates by it.
struct Registration {
  std::string plan;         ///< by the rule for labels (core/names.hpp); no other registration has it
  ContentHash plan_hash{};  ///< SHA-256 of the plan's file, then its image (clients/cli/plan_layer.hpp)
  std::vector<Pick> picks{};
  bool operator==(const Registration&) const = default;
};

inline constexpr std::size_t kMostPicks = 100;         ///< of one registration
inline constexpr std::size_t kMostRegistrations = 20;  ///< of one map
inline constexpr double kPlanReach_m = 1e6;            ///< farthest from a plan's origin, each way
inline constexpr double kLeastPickSigma_m = 0.001;
inline constexpr double kMostPickSigma_m = 10.0;

/// Returns whether both coordinates are numbers within `kPlanReach_m`.
bool is_on_plan(const Eigen::Vector2d& point);
/// Says it for people: "plan hall by 4 picks: dock-2, dock-3, gate, lift".
std::string to_string(const Registration& registration);

}  // namespace weft
