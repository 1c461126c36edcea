#pragma once
#include <memory>
#include <string>
#include <vector>

#include "agents/navigation/config.hpp"
#include "agents/navigation/navigator.hpp"

namespace weft::agents {

/// Holds a navigator, and the sensor whose views are for it (`View::sensor`).
struct SensorNavigator {
  std::string sensor;
  std::unique_ptr<Navigator> navigator;
};

/// Returns one navigator of several, each with a sensor and a method of its own (the one that measures poses first:
/// docs/decisions/027-two-cameras.md); of one, where its body has more sensors than that. All of them are taught at
/// once, an experience each, joined to one another. A lost one is seeded from a localised one, over the joins of the
/// map. The one whose places the route goes through drives, and the next one takes over while the robot rolls.
std::unique_ptr<Navigator> make_multi_method_navigator(std::vector<SensorNavigator> all,
                                                       const NavigationConfig& config);

}  // namespace weft::agents
