#pragma once
#include "agents/agent/process/options.hpp"
#include "agents/methods/method.hpp"
#include "agents/navigation/config.hpp"

namespace weft::agents {

inline constexpr double kMostFootprint_m = 5.0;  ///< that a server takes

/// Returns how far beside its route a robot may be that method M drives: only a method that steers itself leaves it.
template <Method M>
double leaves_route_by_m(const NavigationConfig& navigation) {
  return SteersItself<M> ? navigation.follow.aside_m : 0.0;
}

/// Returns the radius that others keep clear of, around each place that the robot holds: its body's, and as much more
/// as any of its methods may leave the route by.
double told_footprint_m(const Options& options);

}  // namespace weft::agents
