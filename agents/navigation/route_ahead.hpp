#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "agents/methods/method.hpp"
#include "agents/navigation/config.hpp"
#include "core/network/goal.hpp"
#include "core/network/window.hpp"

namespace weft::agents {

/// Describes a place of the route in the robot's frame.
struct RoutePose {
  std::uint32_t index = 0;
  Pose2 robot_from_place;  ///< as the robot comes to face it
  double turn_rad = 0.0;   ///< to be turned on the spot before the way leads on; routes driven both ways have corners
};

/// Holds the route around the robot: places by composed relations, from some behind to a segment ahead, none beyond
/// the released one.
struct RouteAround {
  std::vector<RoutePose> poses;  ///< ascending by index, without gaps
  std::size_t nearest = 0;       ///< position in `poses` of the place nearest to the robot
  Pose2 robot_from_end;          ///< the last of `poses`, as it was taught
};

/// Lays out a hop of a route in the plane: a metric relation as it is, one along a path as an arc.
Pose2 laid_out(const Relation& a_from_b);

/// Returns whether a robot that drives through one of two places can change over to the way through the other, in
/// either direction: near, level, and neither so far to the side nor so much apart in heading that the bend would be
/// steeper than a follower drives.
bool can_cross(const StitchConfig& config, const Relation& a_from_b);

/// Describes a way from the believed place to the route: to the place's own index, or to the nearest place of the
/// route that the window joins it to. `from`: earlier places have been passed. None: not joined within
/// `locate.most_hops`.
struct Joint {
  std::uint32_t index = 0;
  Relation believed_from_route;
};
std::optional<Joint> joint(const NavigationConfig& config, const Window& window, const Route& route,
                           const Estimate& estimate, std::uint32_t from);

/// Lays out the route around the robot. `at`: the last place known to be passed; none at the start, when the nearest
/// one counts. `both_ways`: its places are driven through in either direction, the robot facing the way it drives.
RouteAround around(const NavigationConfig& config, const Route& route, const Joint& joint,
                   const Relation& believed_from_robot, std::optional<std::uint32_t> at, bool both_ways = false);

/// Describes a path that can be driven forwards: from behind the robot up to `segment_m` ahead, without the places
/// that step back or jump sideways where experiences are stitched together.
struct PathAhead {
  std::vector<Pose2> robot_from_path;
  bool reaches_end = false;  ///< its last pose is the released place (or a turn on the spot)
  /// Say, where the path ends at a turn on the spot, to which heading (in the robot's frame) to turn, and which place
  /// is reached by it.
  std::optional<double> turn_to_rad;
  std::uint32_t turn_reaches = 0;
};
PathAhead path_ahead(const NavigationConfig& config, const Route& route, const RouteAround& around);

}  // namespace weft::agents
