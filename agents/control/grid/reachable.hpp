#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "agents/control/grid/room_to_drive.hpp"

namespace weft::agents {

/// Knows which cells a robot can come to from where it stands, over cells that it may be in.
class Reachable {
 public:
  Reachable(const RoomToDrive& room, const Eigen::Vector2d& from);

  /// Returns the point itself where its cell can be come to, else the middle of the nearest such cell within so far
  /// of it; none: there is none.
  std::optional<Eigen::Vector2d> nearest(const Eigen::Vector2d& point, double within_m) const;
  bool reaches(const Eigen::Vector2d& point, double within_m) const { return nearest(point, within_m).has_value(); }

 private:
  Raster raster_;
  std::vector<std::uint8_t> is_reached_;  ///< by cell
};

}  // namespace weft::agents
