#include "agents/bodies/sim/stereo_camera_keys.hpp"

#include <numbers>

#include "agents/bodies/sim/ceiling_camera_keys.hpp"

namespace weft::agents::sim {
namespace {
constexpr double kStereoDegree = std::numbers::pi / 180.0;
}  // namespace

StereoCameraSetup stereo_camera_in(const config::Table& table, StereoCameraSetup c) {
  c.width = static_cast<int>(table.integer("width_px", c.width, 64, 4096));
  c.height = static_cast<int>(table.integer("height_px", c.height, 64, 4096));
  if (c.width % 4 != 0) table.refuse("width_px", "must be a multiple of 4");
  if (c.height % 4 != 0) table.refuse("height_px", "must be a multiple of 4");
  c.focal_px = table.number("focal_px", c.focal_px, 50.0, 5000.0);
  c.baseline_m = table.number("baseline_m", c.baseline_m, 0.02, 1.0);
  c.height_m = table.number("height_m", c.height_m, 0.1, 3.0);
  c.forward_m = table.number("forward_m", c.forward_m, -2.0, 2.0);
  c.left_m = table.number("left_m", c.left_m, -2.0, 2.0);
  c.pitch_rad = table.number("pitch_rad", c.pitch_rad, -0.3, 0.3);
  c.k1 = table.number("k1", c.k1, -0.1, 0.1);
  c.focal_error = 0.01 * table.number("focal_error_percent", 100 * c.focal_error, 0.0, 5.0);
  c.baseline_error = 0.01 * table.number("baseline_error_percent", 100 * c.baseline_error, 0.0, 5.0);
  c.relative_pitch_error_rad =
      kStereoDegree * table.number("relative_pitch_error_deg", c.relative_pitch_error_rad / kStereoDegree, 0.0, 1.0);
  c.relative_yaw_error_rad =
      kStereoDegree * table.number("relative_yaw_error_deg", c.relative_yaw_error_rad / kStereoDegree, 0.0, 1.0);
  read_exposure(table, c);
  c.fps = table.number("fps", c.fps, 1.0, 200.0);
  c.fps_at_rest = table.number("fps_at_rest", c.fps_at_rest, 0.1, 200.0);
  return c;
}

}  // namespace weft::agents::sim
