#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "agents/bodies/sim/site.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::evaluate::topometric {

/// Stands on the floor of a site, as the judge knows it from the site file.
struct TrueSolid {
  std::string name;
  Pose2 site_from_solid;  ///< its middle
  double length_m = 0.0;  ///< along its heading
  double width_m = 0.0;
  double height_m = 0.0;
  bool is_plain = false;  ///< of a wall without texture: no point of it is ever seen
};

/// Describes a point on the outline of what stands in a site, at the height of a robot's body.
struct OutlinePoint {
  Eigen::Vector2d in_site = Eigen::Vector2d::Zero();
  Eigen::Vector2d outwards = Eigen::Vector2d::Zero();
  bool is_plain = false;
};

/// Knows a site's walls, pillars, racks (as boxes), floor and ceiling, for the judge alone. Simulated robots are
/// rendered from other code; what they are told never comes from here.
class TrueHall {
 public:
  /// Knows what stands there on that day, obstacles included, whatever their time of day.
  TrueHall(const agents::sim::Site& site, std::uint64_t day);

  /// Returns how far a ray goes until it meets a solid, the floor or the ceiling, in lengths of `way`; infinity: it
  /// meets nothing.
  double meets_after(const Eigen::Vector3d& from, const Eigen::Vector3d& way) const;
  /// Returns how far a point of the floor is from the rim of the nearest solid; negative: so deep inside of one.
  double to_rim_m(const Eigen::Vector2d& in_site) const;
  /// Returns points on the outlines, so far apart, that do not lie inside of something else.
  std::vector<OutlinePoint> outline(double apart_m) const;
  const std::vector<TrueSolid>& solids() const { return solids_; }

 private:
  std::vector<TrueSolid> solids_;
  double ceiling_m_;
};

/// Returns how far a point is from the rim of a rectangle about a pose, metres; negative inside.
double to_rim_m(const Pose2& site_from_middle, double length_m, double width_m, const Eigen::Vector2d& in_site);

}  // namespace weft::evaluate::topometric
