#pragma once
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "core/ids.hpp"

namespace weft::simulation {

/// Describes a body at a moment, by the truth.
struct Stance {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  bool drives = false;  ///< moves by itself
  bool led = false;     ///< a hand has it
};

/// Tells when two bodies touch while one of them drives by itself. What a hand brings together is the hand's doing
/// until the two are apart again: a robot that is led sees nobody, and nobody can be sent around it in time. So it is
/// where a hand puts a robot down on a way that another one has been given already, until it drives off by itself.
class Contacts {
 public:
  struct Touch {
    RobotId other;
    double gap_m = 0.0;  ///< between the two circles; negative
  };

  /// Notes that the body is there now. Returns those that it touches by a robot's own doing.
  std::vector<Touch> moved(const RobotId& robot, const Stance& now);
  /// Notes that a hand has just let the robot go, on a way that `other` may drive.
  void put_down_before(const RobotId& robot, const RobotId& other) { put_down_.emplace(robot, other); }

 private:
  using Pair = std::pair<RobotId, RobotId>;

  bool is_by_hand(const RobotId& a, const RobotId& b) const;

  std::map<RobotId, Stance> bodies_;
  std::set<Pair> by_hand_;   ///< brought together, and not apart since
  std::set<Pair> put_down_;  ///< the first one before the second
};

}  // namespace weft::simulation
