#pragma once
#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "core/ids.hpp"

namespace weft::server {

/// Remembers from plan to plan which robots are led away from others, and over what: a plan is made anew before all
/// of it is driven, and by the next one the robot would turn back.
class LedRobots {
 public:
  /// Bounds for how many plans a robot is led that stands all the same: what others hold may reach into its way.
  static constexpr std::uint32_t kPlansStood = 30;

  /// Notes that the robot is led over those places from now on.
  void lead(const RobotId& robot, std::vector<PlaceId> over) { led_[robot] = {std::move(over), ++leads_}; }
  /// Returns when the robot was led away last, the larger the later; 0: it never was.
  std::uint64_t led_at(const RobotId& robot) const {
    const auto found = led_.find(robot);
    return found == led_.end() ? 0 : found->second.at;
  }
  /// Returns over which places the robot is led on from there, by one plan more; none: over none. `drives`: it has
  /// not come there yet.
  std::vector<PlaceId> led_on(const RobotId& robot, const PlaceId& from, bool drives) {
    const auto found = led_.find(robot);
    if (found == led_.end()) return {};
    Led& led = found->second;
    const auto here = std::find(led.over.begin(), led.over.end(), from);
    const bool has_driven = drives || here != led.over.end();
    if (here != led.over.end()) led.over.erase(led.over.begin(), here + 1);
    led.stood = has_driven ? 0 : led.stood + 1;
    if (led.stood >= kPlansStood) led.over.clear();
    return led.over;
  }
  /// Notes that the robot is led no farther.
  void end(const RobotId& robot) {
    if (const auto found = led_.find(robot); found != led_.end()) found->second.over.clear();
  }
  /// Forgets all robots for which that does not hold.
  template <class IsThere>
  void forget_unless(IsThere&& is_there) {
    std::erase_if(led_, [&](const auto& led) { return !is_there(led.first); });
  }

 private:
  struct Led {
    std::vector<PlaceId> over;
    std::uint64_t at = 0;
    std::uint32_t stood = 0;  ///< plans since it drove on
  };

  std::map<RobotId, Led> led_;
  std::uint64_t leads_ = 0;
};

}  // namespace weft::server
