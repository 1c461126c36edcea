#pragma once
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "core/ids.hpp"

namespace weft::simulation {

/// A body at a moment, by the truth.
struct Stance {
  Eigen::Vector2d at = Eigen::Vector2d::Zero();
  double radius_m = 0.0;
  bool drives = false;  ///< moves by itself
  bool led = false;     ///< a hand has it
};

/// Tells when two bodies touch while one of them drives by itself. What a hand brings together is the hand's doing
/// until the two are apart again: a robot that is led sees nobody, and nobody can be sent around it in time.
class Contacts {
 public:
  struct Touch {
    RobotId other;
    double gap_m = 0.0;  ///< between the two circles; negative
  };

  /// The body is there now. Returns those that it touches by a robot's own doing.
  std::vector<Touch> moved(const RobotId& robot, const Stance& now);

 private:
  using Pair = std::pair<RobotId, RobotId>;

  std::map<RobotId, Stance> bodies_;
  std::set<Pair> by_hand_;  ///< brought together, and not apart since
};

}  // namespace weft::simulation
