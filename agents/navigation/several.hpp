#pragma once
#include <memory>
#include <string>
#include <vector>

#include "agents/navigation/config.hpp"
#include "agents/navigation/navigator.hpp"

namespace weft::agents {

/// A navigator, and the camera whose views are for it (`View::calibration`).
struct Looking {
  std::string camera;
  std::unique_ptr<Navigator> navigator;
};

/// One navigator of several, each with a camera and a method of its own (two or more, the one that measures poses
/// first: docs/decisions/027-two-cameras.md). All of them are taught at once, an experience each, joined to one
/// another. All of them know where the robot is: who does not is told by one who does, over the joins of the map. The
/// one whose places the route goes through drives, and the next one takes over while the robot rolls.
std::unique_ptr<Navigator> make_several(std::vector<Looking> all, const NavigationConfig& config);

}  // namespace weft::agents
