#pragma once
#include <optional>
#include <string>

#include "core/protocol/messages.hpp"
#include "core/time.hpp"

namespace weft::server {

/// Tells which direction of a robot's link is dead, from what both of its ends have heard: what is cut one way alone
/// (a firewall, a route, an access point) is looked for elsewhere than a link that is down. DDS gives up who has not
/// been heard for 5 s, so that one dead direction makes the other one silent soon: of a robot that is not heard it is
/// told afterwards who of the two heard nothing first.
class LinkDirections {
 public:
  /// Holds what an event says.
  struct Told {
    const char* kind;  ///< robot.deaf, robot.hears or robot.unheard
    std::string cause;
  };

  /// Notes that the robot is heard after it was not for `silence`; none: it had not been heard before.
  void heard_again(std::optional<Duration> silence, SteadyTime now);
  /// Notes that the server could say nothing until now: a robot that has heard nothing is not deaf for that.
  void server_was_away(SteadyTime now);
  /// Takes what the robot says that it has heard of the server. Returns what is news.
  std::optional<Told> hear(const msg::RobotState& state, SteadyTime now);

  /// Returns whether the robot is heard, and has heard nothing for `msg::kDeaf_s`.
  bool is_deaf() const { return is_deaf_; }

 private:
  std::optional<Duration> silence_;  ///< that has just ended, and nothing has been told of it
  SteadyTime since_;                 ///< heard without a break
  bool is_deaf_ = false;
};

}  // namespace weft::server
