#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "agents/bodies/sim/sim_body.hpp"
#include "agents/perception/motion.hpp"
#include "core/result.hpp"

namespace weft::evaluate::ceiling {

/// Returns the command of the law of Lucas et al., V.B: straight on within the gap of 10 pixels to either side of the
/// line; beyond it the wheel on that side turns faster by 1 rad/s. `left_px`: how far the robot is left of the line.
/// Pixels of the image. They print neither speed nor wheels: 0.4 m/s and wheels of 5 cm radius, a small robot's.
agents::Twist published_command(double left_px, double track_m);

/// Tells where the robot was beside the line that it was to follow, truly.
struct BesideLine {
  double along_m = 0.0;
  double left_m = 0.0;
};

/// Has the robot drive straight on for so many metres by the mosaic and the law as published, from where the site
/// puts it. Ends early where the robot is 2 m beside the line or has
/// taken three times as long as it needs. None: stopped.
Result<std::optional<std::vector<BesideLine>>> drive_as_published(const agents::sim::SimBodyConfig& body,
                                                                  double metres,
                                                                  const std::function<bool()>& asked_to_stop);

/// Holds RMS and largest distance from the line, metres; NaN of nothing.
struct BesideErrors {
  double rms_m;
  double worst_m;
};
BesideErrors errors_of(const std::vector<BesideLine>& drive);

}  // namespace weft::evaluate::ceiling
