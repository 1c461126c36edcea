#pragma once
#include <vector>

#include "agents/bodies/body.hpp"
#include "agents/bodies/sim/site.hpp"
#include "agents/bodies/sim/wave.hpp"

namespace weft::agents::sim {

/// Leads a robot along a line as a person does, not very well. Knows the robot's true pose, and tells nobody.
class Hand {
 public:
  /// Makes a hand that leads along `line`. invalid: fewer than two points, not finite, the start further than 1.5 m
  /// from the robot, or closer to a box than the robot's radius; the message names the point or segment.
  static Result<Hand> along(const std::vector<SitePoint>& line, const Site& site, const Pose2& site_from_robot,
                            Random random);

  /// Returns what the hand asks of the base now. Zero once at the end.
  Twist command(const Pose2& site_from_robot, double time_s);
  bool at_end() const { return at_end_; }

 private:
  Hand(const HandSetup& setup, const BaseSetup& base, std::vector<SitePoint> line, Random random);
  SitePoint point_at(double along_m) const;
  Pose2 aim_at(double along_m) const;
  void follow_progress(const Pose2& site_from_robot);

  HandSetup setup_;
  BaseSetup base_;
  std::vector<SitePoint> line_;
  std::vector<double> along_m_;  ///< of each point
  BoundedWave aside_;            ///< of the way, metres
  BoundedWave pace_;             ///< of the time
  double progress_m_ = 0.0;
  bool at_end_ = false;
};

}  // namespace weft::agents::sim
