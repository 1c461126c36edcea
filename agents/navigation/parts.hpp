#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/navigation/config.hpp"
#include "agents/navigation/navigator.hpp"

/// What one of several navigators of a robot is to the others (several.hpp).
namespace weft::agents {

struct Part {
  std::string camera;
  std::unique_ptr<Navigator> navigator;
  Motion since = {};          ///< its last step
  Navigated last = {};        ///< what that led to
  Duration since_hint = {};   ///< since it was told where it is
  ExperienceId teaches = {};  ///< none: is not being taught

  bool knows() const { return navigator->estimate() && !last.lost; }
  /// Its camera has given nothing for so long that it counts as blind; longer at rest, when images are rare.
  bool is_silent() const;
};
using Parts = std::vector<Part>;

/// Whoever does not know where the robot is, is told by who knows best: `active`, if it does. Once a second.
void tell_who_does_not_know(Parts& parts, std::size_t active, const NavigationConfig& config, const Window& window);

/// Who drives from now on instead of `active`: it sees what the route's next place after `at` was seen with, has seen
/// lately where it is, and does not contradict `active`. None: nobody.
std::optional<std::size_t> successor(const Parts& parts, std::size_t active, const NavigationConfig& config,
                                     const Window& window, const Route& route, std::uint32_t at);

}  // namespace weft::agents
