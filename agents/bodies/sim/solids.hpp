#pragma once
#include <string>
#include <vector>

#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// Holds what a robot can run into: the boxes of a site, its obstacles while they stand there, and its movers where
/// they are. Pure: the same calls give the same.
class Solids {
 public:
  explicit Solids(const Site& site);

  /// Lets time go on while the robot stands there. Persons who are not rude wait rather than come nearer to it than
  /// 0.3 m.
  void advance(const Pose2& site_from_robot, double duration_s);

  /// Returns the name of what keeps the robot from getting from the one pose to the other; null: nothing does. What
  /// came over it lets it go, but no deeper in.
  const std::string* in_the_way(const Pose2& from, const Pose2& to) const;
  /// Returns the name of an obstacle or a mover that has come over the robot there; null: none has.
  const std::string* touching(const Pose2& site_from_robot) const;
  /// Returns how long each mover has waited until now, s: it is where it would have been so much earlier.
  const std::vector<double>& waited_s() const { return waited_s_; }

 private:
  /// Describes what of a thing stands on the floor.
  struct Footprint {
    Pose2 site_from_middle;
    double length_m = 0.0, width_m = 0.0;
    std::size_t thing = 0;  ///< counts obstacles, then movers
  };
  Footprint footprint_of(std::size_t mover, double at_s) const;
  const std::string& name_of(const Footprint& footprint) const;
  double gap_m(const Footprint& footprint, const Pose2& site_from_robot) const;
  bool waits(std::size_t mover, const Pose2& site_from_robot, double duration_s) const;
  const Box* touched_box(const Pose2& site_from_robot) const;
  void stand_now();

  std::vector<Box> boxes_;
  std::vector<Obstacle> obstacles_;
  std::vector<Mover> movers_;
  double radius_m_, body_height_m_;
  double now_s_ = 0.0;
  std::vector<double> waited_s_;
  std::vector<Footprint> now_;  ///< of obstacles and movers
};

}  // namespace weft::agents::sim
