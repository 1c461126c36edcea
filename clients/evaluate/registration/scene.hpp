#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "core/geometry/pose3.hpp"
#include "core/random.hpp"

namespace weft::evaluate::registration {

/// Describes a box with faces along the axes. `seen`: the share of its surface that stereo finds a depth for; a plain
/// wall has none.
struct SceneBox {
  Eigen::Vector3d low;
  Eigen::Vector3d high;
  double seen = 1.0;
};

/// Holds a building's inside as boxes, floor and walls included. z up, floor at 0.
struct Scene {
  std::vector<SceneBox> boxes;
  Pose2 start;            ///< where a run begins
  double length_m = 0.0;  ///< how far it may go straight on
};

enum class SceneKind : std::uint8_t {
  room,   ///< walls, pillars, cabinets and crates at any place
  aisle,  ///< 2 m wide, with pillars 0.15 m deep every 3 to 6 m and some crates
  plain   ///< an aisle of walls alone: nothing tells how far along it is
};
std::string_view name_of(SceneKind kind);

Scene made_scene(SceneKind kind, Random& random);

/// Describes what a ray meets.
struct Met {
  double distance = 0.0;  ///< in lengths of `ray`
  std::size_t box = 0;
};
/// Returns the first box that a ray meets, none beyond `most` lengths.
std::optional<Met> first_met(const Scene& scene, const Eigen::Vector3d& from, const Eigen::Vector3d& ray,
                             double most);

}  // namespace weft::evaluate::registration
