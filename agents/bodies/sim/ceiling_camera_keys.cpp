#include "agents/bodies/sim/ceiling_camera_keys.hpp"

#include <cmath>
#include <numbers>

#include "agents/bodies/sim/calibration.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/rig.hpp"

namespace weft::agents::sim {
namespace {

using config::Table;

constexpr double kRadians = std::numbers::pi / 180.0;  // a degree

double angle_in(const Table& table, const char* key, double otherwise_rad, double most_deg) {
  return kRadians * table.number(key, otherwise_rad / kRadians, -most_deg, most_deg);
}

void read_lens(const Table& table, CeilingCameraSetup& c) {
  const std::string given = c.lens == LensModel::equidistant ? "equidistant" : "radtan";
  const bool is_fisheye = table.choice("lens", given, {"radtan", "equidistant"}) == "equidistant";
  const LensModel lens = is_fisheye ? LensModel::equidistant : LensModel::radtan;
  if (lens != c.lens) c.k1 = c.k2 = c.k3 = c.k4 = c.p1 = c.p2 = 0.0;  // another model's mean something else
  c.lens = lens;
  c.k1 = table.number("k1", c.k1, -0.4, 0.4);
  c.k2 = table.number("k2", c.k2, -0.2, 0.2);
  c.k3 = table.number("k3", c.k3, -0.1, 0.1);
  if (is_fisheye) {
    c.k4 = table.number("k4", c.k4, -0.1, 0.1);
    c.widest_rad = table.number("widest_rad", c.widest_rad, 0.3, 1.4);
  } else {
    c.p1 = table.number("p1", c.p1, -0.01, 0.01);
    c.p2 = table.number("p2", c.p2, -0.01, 0.01);
  }
}

Mast mast_in(const Table& table, const CeilingCameraSetup& camera) {
  Mast m;
  m.forward_m = table.number("forward_m", m.forward_m, -2.0, 2.0);
  m.left_m = table.number("left_m", m.left_m, -2.0, 2.0);
  m.side_m = table.number("side_m", m.side_m, 0.005, 1.0);
  m.height_m = table.number("height_m", m.height_m, 0.1, 12.0);
  m.grey = table.number("grey", m.grey, 5.0, 250.0);
  const double away_m = std::hypot(m.forward_m - camera.forward_m, m.left_m - camera.left_m);
  if (away_m < 0.75 * m.side_m + 0.02)
    table.refuse("forward_m", "must be further from the camera: it would be in it");
  return m;
}

}  // namespace

void read_exposure(const Table& table, ExposureSetup& exposure) {
  exposure.exposes_itself = table.boolean("exposes_itself", exposure.exposes_itself);
  exposure.mean_grey = table.number("mean_grey", exposure.mean_grey, 20.0, 230.0);
  exposure.longest_exposure_s =
      1e-3 * table.number("longest_exposure_ms", 1e3 * exposure.longest_exposure_s, 0.1, 100.0);
  exposure.most_gain = table.number("most_gain", exposure.most_gain, 1.0, 1000.0);
}

CeilingCameraSetup ceiling_camera_in(const Table& table, CeilingCameraSetup c) {
  c.width = static_cast<int>(table.integer("width_px", c.width, 64, 4096));
  c.height = static_cast<int>(table.integer("height_px", c.height, 64, 4096));
  if (c.width % 4 != 0) table.refuse("width_px", "must be a multiple of 4");
  if (c.height % 4 != 0) table.refuse("height_px", "must be a multiple of 4");
  c.focal_px = table.number("focal_px", c.focal_px, 50.0, 5000.0);
  c.cx_px = table.number("cx_px", (c.width - 1) / 2.0, 0.0, 4096.0);
  c.cy_px = table.number("cy_px", (c.height - 1) / 2.0, 0.0, 4096.0);
  read_lens(table, c);
  c.height_m = table.number("height_m", c.height_m, 0.1, 3.0);
  c.forward_m = table.number("forward_m", c.forward_m, -2.0, 2.0);
  c.left_m = table.number("left_m", c.left_m, -2.0, 2.0);
  c.tilt_forward_rad = angle_in(table, "tilt_forward_deg", c.tilt_forward_rad, 40.0);
  c.tilt_left_rad = angle_in(table, "tilt_left_deg", c.tilt_left_rad, 40.0);
  c.yaw_rad = angle_in(table, "yaw_deg", c.yaw_rad, 360.0);
  c.tilt_error_forward_rad = angle_in(table, "tilt_error_forward_deg", c.tilt_error_forward_rad, 30.0);
  c.tilt_error_left_rad = angle_in(table, "tilt_error_left_deg", c.tilt_error_left_rad, 30.0);
  c.bloom = 0.01 * table.number("bloom_percent", 100 * c.bloom, 0.0, 50.0);
  read_exposure(table, c);
  c.fps = table.number("fps", c.fps, 1.0, 200.0);
  c.fps_at_rest = table.number("fps_at_rest", c.fps_at_rest, 0.1, 200.0);
  if (table.has("mast")) c.mast = mast_in(table.table("mast"), c);
  const CameraModel told = given_ceiling_camera_from(c, {}, "a robot");
  if (gaze_of(told) != Gaze::up)
    table.refuse("tilt_forward_deg", "and tilt_left_deg lean it so far that it does not look up");
  if (const Result<void> sound = check(told); !sound)
    table.refuse("focal_px", "makes no sound lens: " + sound.error().message);
  return c;
}

}  // namespace weft::agents::sim
