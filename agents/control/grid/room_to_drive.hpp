#pragma once
#include <algorithm>

#include "agents/control/grid/clearance.hpp"

namespace weft::agents {

/// Tells where a round robot may be: where its radius and no less is free around it. A robot that stands nearer to
/// something may leave: within its radius of where it is, places count that have no less room than it has there.
class RoomToDrive {
 public:
  RoomToDrive(const DistanceMap& clearance, double radius_m, const Eigen::Vector2d& robot)
      : clearance_(&clearance),
        radius_m_(radius_m),
        robot_(robot),
        least_m_(std::min(radius_m, clearance.at(robot))) {}

  bool allows(const Eigen::Vector2d& point, double clearance_m) const {
    if (clearance_m >= radius_m_) return true;
    return least_m_ < radius_m_ && clearance_m >= least_m_ && (point - robot_).norm() <= radius_m_;
  }
  bool allows(const Eigen::Vector2d& point) const { return allows(point, clearance_->at(point)); }
  const DistanceMap& clearance() const { return *clearance_; }
  double radius_m() const { return radius_m_; }

 private:
  const DistanceMap* clearance_;  ///< outlives this
  double radius_m_;
  Eigen::Vector2d robot_;
  double least_m_;
};

}  // namespace weft::agents
