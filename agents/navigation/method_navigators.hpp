#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/navigation/config.hpp"
#include "agents/navigation/navigator.hpp"

/// Holds the navigators of a robot with several methods, and what they tell one another (multi_method_navigator.hpp).
namespace weft::agents {

/// Holds the navigator of one method, and what has happened since it stepped last.
struct MethodNavigator {
  std::string sensor;
  std::unique_ptr<Navigator> navigator;
  Motion since = {};           ///< its last step
  Duration rolls_unseen = {};  ///< without a view of its sensor, since the robot began to roll
  Navigated last = {};         ///< what its last step led to
  Duration since_hint = {};    ///< since it was told where it is
  ExperienceId teaches = {};   ///< none: is not being taught

  bool knows() const { return navigator->estimate() && !last.lost; }
  /// Returns its estimate carried on by the motion since its last step.
  std::optional<Estimate> now() const;
  void moves(const Motion& motion);
  /// Returns whether it is to step without a view: while the robot rolls with its camera silent, at each sample, as a
  /// robot with this camera alone would be; at rest, when images are rare, now and then.
  bool is_due_blind() const;
  Motion take_motion(bool sees);
};
using MethodNavigators = std::vector<MethodNavigator>;

/// Seeds lost navigators from a localised one (the active one if possible), at most once a second.
void seed_lost(MethodNavigators& navigators, std::size_t active, const NavigationConfig& config,
               const Window& window);

/// Makes the less sure of two believe the other, if that one has just seen where it is: of who drives now and who
/// drives soon on the route, where they believe themselves in different places. At most once a second.
void correct_mistaken(MethodNavigators& navigators, std::size_t active, const NavigationConfig& config,
                      const Window& window, const Route& route, std::uint32_t at);

/// Returns which navigator drives from now on instead of `active`: it sees what the route's next place after `at` was
/// seen with, has seen lately where it is, and does not contradict `active`. None: nobody.
std::optional<std::size_t> successor(const MethodNavigators& navigators, std::size_t active,
                                     const NavigationConfig& config, const Window& window, const Route& route,
                                     std::uint32_t at);

}  // namespace weft::agents
