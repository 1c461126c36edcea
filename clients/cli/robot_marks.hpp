#pragma once
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/layout.hpp"
#include "core/protocol/messages.hpp"

namespace weft::cli {

/// Describes a robot as a picture of the network shows it.
struct RobotMark {
  /// Says what is known of it. lost: it does not know where it is, and stands where it last did; silent: unheard.
  enum class Look { heard, lost, silent };
  std::string name;
  std::string words;  ///< name and mode
  Look look = Look::heard;
  std::optional<Pose2> drawing_from_robot;  ///< none: only what it holds is known
  double radius_m = 0.0;                    ///< of its footprint
  std::vector<PlaceId> held;                ///< in order; one: it holds where it stands
  bool is_held_whole = true;                ///< false: only the ends of `held` are known, not what lies between
  std::vector<PlaceId> ahead;               ///< the rest of its route, from where it is released to, to its goal
};

struct RobotsOnMap {
  struct NotDrawn {
    std::string name;
    std::string why;
  };
  std::vector<RobotMark> drawn;  ///< by name
  std::vector<NotDrawn> not_drawn;
};

/// Returns the robots of the drawing's places, with what the server tells that they hold. `goals` and `routes` are
/// the server's answer about all goals.
RobotsOnMap robots_on_map(const Layout& layout, std::vector<msg::RobotRow> rows, const std::vector<Goal>& goals,
                          const std::vector<Route>& routes);

}  // namespace weft::cli
