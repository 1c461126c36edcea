#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

#include "agents/control/grid/room_to_drive.hpp"

namespace weft::agents {

struct GridPathConfig {
  double comfort_m = 0.3;       ///< beyond the radius; ways with less room cost more; [0, 2]
  double cost_of_narrow = 3.0;  ///< times a way's length more, where there is no room to spare; [0, 20]
  double goal_within_m = 0.3;   ///< a goal without room is replaced by the nearest place this near; [0, 2]
};

/// Finds the way of least cost over the cells that a robot may be in (A*: Hart, Nilsson & Raphael 1968, eight
/// neighbours, octile distance): the middles of its cells from the robot's to the goal's. None: there is no way, or
/// no room at the goal.
std::optional<std::vector<Eigen::Vector2d>> find_path(const GridPathConfig& config, const RoomToDrive& room,
                                                      const Eigen::Vector2d& from, const Eigen::Vector2d& to);

}  // namespace weft::agents
