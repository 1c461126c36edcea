#pragma once
#include "agents/bodies/sim/exposure_setup.hpp"

namespace weft::agents::sim {

/// Describes a pair of cameras that look ahead side by side, behind one shutter. Agents are told its calibration; the
/// true pair differs by what is drawn from the errors, whose RMS these are, by robot and day.
struct StereoCameraSetup : ExposureSetup {
  int width = 320, height = 240;
  double focal_px = 208.0;
  double baseline_m = 0.12;  ///< the right camera is so far to the right of the left one
  double height_m = 0.45, forward_m = 0.15, left_m = 0.0,
         pitch_rad = 0.1;  ///< of their middle; pitch down from level
  double k1 = 0.0;         ///< that is left of a lens which agents take for rectified
  double focal_error = 0.003;
  double baseline_error = 0.002;                                  ///< share
  double relative_pitch_error_rad = 0.02 * 0.017453292519943295;  ///< of the right camera against the left
  double relative_yaw_error_rad = 0.01 * 0.017453292519943295;    ///< likewise: 0.04 px of disparity at f = 208
  double fps = 10.0, fps_at_rest = 2.0;
};

}  // namespace weft::agents::sim
