#pragma once
#include <Eigen/Core>
#include <vector>

#include "agents/perception/attitude.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

using Polygon = std::vector<Eigen::Vector2d>;

/// Returns the signed area, positive when counter-clockwise.
double area(const Polygon& polygon);
Polygon counter_clockwise(Polygon polygon);

/// Returns the part of a convex polygon where normal . p + offset >= 0.
Polygon clip_half_plane(const Polygon& polygon, const Eigen::Vector2d& normal, double offset);
/// Returns the common part of two polygons, both convex and counter-clockwise (Sutherland & Hodgman 1974).
Polygon intersection(const Polygon& a, const Polygon& b);

/// Describes the part of a plane that one camera sees: its footprint and how plane becomes image.
struct SeenPlane {
  Polygon footprint;  ///< robot frame, counter-clockwise
  Eigen::Matrix3d camera_from_plane = Eigen::Matrix3d::Identity();
};

/// Returns the overlap (Gadd & Newman, eq. 3, which names no denominator): the share of b's footprint, by image area
/// in b's own view, that lies inside a's footprint, [0, 1]. It is not symmetric for a pitched camera.
double share_of_b_seen_in_a(const SeenPlane& a, const SeenPlane& b, const Pose2& a_from_b);

}  // namespace weft::agents
