#pragma once
#include <memory>
#include <string>
#include <vector>

#include "agents/navigation/config.hpp"
#include "agents/navigation/navigator.hpp"

namespace weft::agents {

/// A navigator, and the sensor whose views are for it (`View::sensor`).
struct Looking {
  std::string sensor;
  std::unique_ptr<Navigator> navigator;
};

/// Returns one navigator of several, each with a sensor and a method of its own (the one that measures poses first:
/// docs/decisions/027-two-cameras.md); of one, where its body has more sensors than that. All of them are taught at
/// once, an experience each, joined to one another. All of them know where the robot is: who does not is told by one
/// who does, over the joins of the map. The one whose places the route goes through drives, and the next one takes
/// over while the robot rolls.
std::unique_ptr<Navigator> make_several(std::vector<Looking> all, const NavigationConfig& config);

}  // namespace weft::agents
