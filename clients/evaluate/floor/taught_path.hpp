#pragma once
#include <vector>

#include "clients/evaluate/floor/trace.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::evaluate::floor {

/// Tells where a robot truly was led: a polyline with headings.
class TaughtPath {
 public:
  explicit TaughtPath(const Trace& taught);

  struct Nearest {
    double along_m = 0.0;
    double lateral_m = 0.0;    ///< distance from the polyline, left of it positive
    double heading_rad = 0.0;  ///< turned left against the heading that was taught there
  };
  /// Returns the nearest point within `reach_m` along the path from `along_m`, so that a path that comes by a second
  /// time is not taken for itself.
  Nearest nearest(const Pose2& site_from_robot, double along_m, double reach_m) const;
  /// Returns the nearest point anywhere on it.
  Nearest nearest(const Pose2& site_from_robot) const;

  const std::vector<Pose2>& poses() const { return poses_; }
  double length_m() const { return along_.back(); }

 private:
  std::vector<Pose2> poses_;
  std::vector<double> along_;
};

}  // namespace weft::evaluate::floor
