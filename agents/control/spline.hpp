#pragma once
#include <cstddef>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Describes a point of a path: its pose, x forward along the path, and the curvature there (left positive).
struct PathPoint {
  Pose2 pose;
  double curvature_1_m = 0.0;
};

/// Interpolates poses by cubic Hermite splines (Gadd & Newman III-D, after Mettke 1983): each pose is passed at its
/// own heading, so neighbouring pieces meet without a jump of position or direction, and a piece depends on its two
/// ends only (cutting a longer path elsewhere does not move it). Parametrised by arc length. Frame: that of the
/// poses.
class Spline {
 public:
  /// Returns the spline through the poses; one pose is a path without length. invalid: no pose, a number that is not
  /// finite, or neighbours closer than 1 mm.
  static Result<Spline> through(const std::vector<Pose2>& poses);

  double length_m() const { return samples_.back().along_m; }
  /// Returns the point at `along_m`; outside [0, length] it lies straight on along the heading of the nearer end.
  PathPoint at(double along_m) const;
  /// Returns the arc length at the i-th pose.
  double along_of(std::size_t i) const { return samples_[i * samples_a_piece].along_m; }
  std::size_t size() const { return poses_.size(); }
  /// Returns the arc length, within [from_m, to_m], of the point nearest to `point`; it is below 0 or above the
  /// length, by any distance that the range allows, when `point` lies behind the first or beyond the last pose.
  double nearest(const Eigen::Vector2d& point, double from_m, double to_m) const;

 private:
  static constexpr std::size_t samples_a_piece = 8;
  struct Sample {
    double along_m = 0.0;
    Eigen::Vector2d point = Eigen::Vector2d::Zero();
  };
  PathPoint evaluate(std::size_t piece, double u) const;

  std::vector<Pose2> poses_;
  std::vector<Sample> samples_;  // samples_a_piece for each piece, and the end
};

}  // namespace weft::agents
