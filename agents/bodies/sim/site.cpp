#include "agents/bodies/sim/site.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "agents/bodies/sim/base.hpp"
#include "agents/bodies/sim/blackout_keys.hpp"
#include "agents/bodies/sim/ceiling_camera_keys.hpp"
#include "agents/bodies/sim/ceiling_keys.hpp"
#include "agents/bodies/sim/change_keys.hpp"
#include "agents/bodies/sim/changes.hpp"
#include "agents/bodies/sim/floor/materials.hpp"
#include "agents/bodies/sim/solid_keys.hpp"
#include "agents/bodies/sim/stereo_camera_keys.hpp"
#include "core/config/config.hpp"

namespace weft::agents::sim {
namespace {

using config::required;
using config::Table;

constexpr double kFar = 1000.0;  // metres: no warehouse reaches further
constexpr double kDegree = std::numbers::pi / 180.0;

std::optional<double> in_degrees(double radians) {
  return radians / kDegree;
}

Pose2 pose_in(const Table& table) {
  Pose2 pose;
  pose.x = table.number("x", required, -kFar, kFar);
  pose.y = table.number("y", required, -kFar, kFar);
  pose.heading = kDegree * table.number("heading_deg", 0.0, -360.0, 360.0);
  return pose;
}

FloorSetup floor_in(const Table& table) {
  FloorSetup floor;
  floor.x_min = table.number("x_min", required, -kFar, kFar);
  floor.y_min = table.number("y_min", required, -kFar, kFar);
  floor.x_max = table.number("x_max", required, -kFar, kFar);
  floor.y_max = table.number("y_max", required, -kFar, kFar);
  if (floor.x_max <= floor.x_min) {
    table.refuse("x_max", "must be greater than x_min");
  }
  if (floor.y_max <= floor.y_min) {
    table.refuse("y_max", "must be greater than y_min");
  }
  std::vector<std::string> names;
  for (const Material& material : materials()) {
    names.push_back(material.name);
  }
  floor.material = table.choice("material", floor.material, names);
  floor.photograph = table.text("photograph", floor.photograph);
  floor.seed = static_cast<std::uint64_t>(table.integer("seed", 1, 0, INT64_MAX));
  floor.brightness = table.number("brightness", floor.brightness, 20.0, 230.0);
  floor.contrast = table.number("contrast", floor.contrast, 0.0, 4.0);
  floor.gloss = table.number("gloss", floor.gloss, 0.0, 10.0);
  floor.cache_mb = table.number("cache_mb", floor.cache_mb, 64.0, 256.0);
  return floor;
}

/// Reads how large a rack is, or takes the sizes of the one that it is like.
void read_rack_size(const Table& table, const Site& site, Box& rack) {
  rack.like = table.text("like", "");
  if (rack.like.empty()) {
    rack.length_m = table.number("length_m", required, 0.1, 200.0);
    rack.width_m = table.number("width_m", 1.0, 0.1, 20.0);
    rack.height_m = table.number("height_m", 4.0, 0.1, 20.0);
    return;
  }
  const auto other = std::find_if(site.boxes.begin(), site.boxes.end(),
                                  [&rack](const Box& box) { return box.name == rack.like && box.like.empty(); });
  if (other == site.boxes.end()) {
    table.refuse("like", "names no [[rack]] before it that is like none itself: \"" + rack.like + "\"");
    return;
  }
  rack.length_m = other->length_m;
  rack.width_m = other->width_m;
  rack.height_m = other->height_m;
}

void add_racks(const Table& root, Site& site) {
  for (const Table& table : root.tables("rack", 0, 1000)) {
    Box box;
    box.kind = Box::Kind::rack;
    box.name = table.text("name", "rack " + std::to_string(site.boxes.size() + 1));
    box.site_from_box = pose_in(table);
    read_rack_size(table, site, box);
    site.boxes.push_back(box);
  }
}

/// Reads how much there is to see on a wall.
void read_contrast(const Table& table, Box& wall) {
  constexpr double of_plain = 0.02;
  const bool is_plain = table.boolean("plain", false);
  if (is_plain && table.has("contrast"))
    table.refuse("contrast", "is 0.02 where plain = true; leave out one of them");
  wall.contrast = table.number("contrast", is_plain ? of_plain : wall.contrast, 0.0, 1.0);
  wall.has_signs = !is_plain;
}

void add_walls(const Table& root, Site& site) {
  for (const Table& table : root.tables("wall", 0, 1000)) {
    const std::vector<double> from = table.numbers("from", required, 2, 2, -kFar, kFar);
    const std::vector<double> to = table.numbers("to", required, 2, 2, -kFar, kFar);
    Box box;
    box.kind = Box::Kind::wall;
    box.name = table.text("name", "wall " + std::to_string(site.boxes.size() + 1));
    box.width_m = table.number("thickness_m", 0.2, 0.02, 2.0);
    box.height_m = table.number("height_m", 5.0, 0.1, 20.0);
    read_contrast(table, box);
    if (from.size() == 2 && to.size() == 2) {
      box.length_m = std::hypot(to[0] - from[0], to[1] - from[1]);
      box.site_from_box = {(from[0] + to[0]) / 2, (from[1] + to[1]) / 2,
                           std::atan2(to[1] - from[1], to[0] - from[0])};
      if (box.length_m < 0.1) {
        table.refuse("to", "must be at least 0.1 m from `from`");
      }
    }
    site.boxes.push_back(box);
  }
}

void add_pillars(const Table& root, Site& site) {
  for (const Table& table : root.tables("pillar", 0, 1000)) {
    Box box;
    box.kind = Box::Kind::pillar;
    box.name = table.text("name", "pillar " + std::to_string(site.boxes.size() + 1));
    box.site_from_box = pose_in(table);
    box.length_m = box.width_m = table.number("side_m", 0.4, 0.05, 5.0);
    box.height_m = table.number("height_m", 5.0, 0.1, 20.0);
    site.boxes.push_back(box);
  }
}

void add_names_and_lamps(const Table& root, Site& site) {
  for (const Table& table : root.tables("station", 0, 1000)) {
    site.stations.push_back({table.text("name", required), pose_in(table)});
  }
  for (const Table& table : root.tables("lamp", 0, 1000)) {
    Lamp lamp;
    lamp.x = table.number("x", required, -kFar, kFar);
    lamp.y = table.number("y", required, -kFar, kFar);
    read_shining(table, lamp);
    site.lamps.push_back(lamp);
  }
}

/// Reads with what a robot looks, each way once.
void read_looks(const Table& table, RobotStart& robot) {
  std::vector<Gaze>& looks = robot.looks;
  looks.clear();
  for (const std::string& word : table.texts("looks", std::vector<std::string>{to_string(Gaze::down)}, 1, 4)) {
    if (word == "stereo" && !robot.has_stereo) {
      robot.has_stereo = true;
      continue;
    }
    Gaze gaze = Gaze::down;
    if (word == to_string(Gaze::ahead)) gaze = Gaze::ahead;
    if (word == to_string(Gaze::up)) gaze = Gaze::up;
    if (word != to_string(gaze))
      table.refuse("looks",
                   "a camera looks \"down\", \"ahead\" or \"up\", not \"" + word + "\"; a pair is \"stereo\", once");
    if (std::find(looks.begin(), looks.end(), gaze) != looks.end()) {
      table.refuse("looks", "two cameras look " + word + "; give each way once");
    }
    looks.push_back(gaze);
  }
}

/// Refuses a robot that would stand in something when its body's time begins.
void refuse_stands_in(const Table& table, const RobotStart& robot, const Site& site) {
  const Pose2& at = robot.site_from_robot;
  for (const Box& box : site.boxes) {
    if (distance_to(box, at.x, at.y) < site.base.radius_m)
      table.refuse("x", robot.name + " would stand in " + box.name);
  }
  for (const Obstacle& o : site.obstacles) {
    if (o.stands_at(0.0) &&
        distance_to_rim(o.site_from_obstacle, o.length_m, o.width_m, at.x, at.y) < site.base.radius_m)
      table.refuse("x", robot.name + " would stand in " + o.name);
  }
}

void add_robots(const Table& root, Site& site) {
  std::set<std::string> names;
  for (const Table& table : root.tables("robot", 1, 1000)) {
    RobotStart robot;
    robot.name = table.text("name", required, 64);
    robot.site_from_robot = pose_in(table);
    robot.seed = static_cast<std::uint64_t>(table.integer("seed", 0, 0, INT64_MAX));
    read_looks(table, robot);
    if (table.has("ceiling_camera"))
      robot.ceiling_camera = ceiling_camera_in(table.table("ceiling_camera"), site.ceiling_camera);
    if (robot.name.find_first_of("\"\\\n\r\t") != std::string::npos) {
      table.refuse("name", "must not hold quotes, backslashes or control characters");
    }
    if (!names.insert(robot.name).second) {
      table.refuse("name", "two robots are called \"" + robot.name + "\"");
    }
    refuse_stands_in(table, robot, site);
    site.robots.push_back(robot);
  }
}

CameraSetup camera_in(const Table& table) {
  CameraSetup c;
  c.width = static_cast<int>(table.integer("width_px", c.width, 64, 4096));
  if (c.width % 8 != 0) {
    table.refuse("width_px", "must be a multiple of 8");
  }
  c.height = static_cast<int>(table.integer("height_px", c.height, 64, 4096));
  if (c.height % 8 != 0) {
    table.refuse("height_px", "must be a multiple of 8");
  }
  c.focal_px = table.number("focal_px", c.focal_px, 50.0, 5000.0);
  c.cx_px = table.number("cx_px", (c.width - 1) / 2.0, 0.0, 4096.0);
  c.cy_px = table.number("cy_px", (c.height - 1) / 2.0, 0.0, 4096.0);
  c.k1 = table.number("k1", c.k1, -0.4, 0.4);
  c.k2 = table.number("k2", c.k2, -0.2, 0.2);
  c.p1 = table.number("p1", c.p1, -0.01, 0.01);
  c.p2 = table.number("p2", c.p2, -0.01, 0.01);
  c.k3 = table.number("k3", c.k3, -0.1, 0.1);
  c.height_m = table.number("height_m", c.height_m, 0.1, 3.0);
  c.forward_m = table.number("forward_m", c.forward_m, -2.0, 2.0);
  c.left_m = table.number("left_m", c.left_m, -2.0, 2.0);
  c.pitch_rad = table.number("pitch_rad", c.pitch_rad, 0.5, std::numbers::pi / 2);
  c.fps = table.number("fps", c.fps, 1.0, 200.0);
  c.fps_at_rest = table.number("fps_at_rest", c.fps_at_rest, 0.1, 200.0);
  return c;
}

/// Reads the forward camera; it takes images as often as the floor's camera, if it does not say otherwise.
ForwardCameraSetup forward_camera_in(const Table& table, const CameraSetup& floor) {
  ForwardCameraSetup c;
  c.width = static_cast<int>(table.integer("width_px", c.width, 64, 4096));
  c.height = static_cast<int>(table.integer("height_px", c.height, 64, 4096));
  if (c.width % 4 != 0) table.refuse("width_px", "must be a multiple of 4");
  if (c.height % 4 != 0) table.refuse("height_px", "must be a multiple of 4");
  c.focal_px = table.number("focal_px", c.focal_px, 50.0, 5000.0);
  c.k1 = table.number("k1", c.k1, -0.4, 0.4);
  c.height_m = table.number("height_m", c.height_m, 0.1, 3.0);
  c.forward_m = table.number("forward_m", c.forward_m, -2.0, 2.0);
  c.left_m = table.number("left_m", c.left_m, -2.0, 2.0);
  c.pitch_rad = table.number("pitch_rad", c.pitch_rad, -0.5, 0.5);
  read_exposure(table, c);
  c.headlight = table.number("headlight", c.headlight, 0.0, 100.0);
  c.fps = table.number("fps", floor.fps, 1.0, 200.0);
  c.fps_at_rest = table.number("fps_at_rest", floor.fps_at_rest, 0.1, 200.0);
  return c;
}

HallSetup hall_in(const Table& table) {
  HallSetup h;
  h.ceiling_m = table.number("ceiling_m", h.ceiling_m, 2.0, 40.0);
  h.ceiling_grey = table.number("ceiling_grey", h.ceiling_grey, 5.0, 250.0);
  h.wall_grey = table.number("wall_grey", h.wall_grey, 5.0, 250.0);
  h.ceiling = ceiling_in(table);
  return h;
}

BaseSetup base_in(const Table& table) {
  BaseSetup b;
  b.has_encoders = table.boolean("has_encoders", b.has_encoders);
  b.track_m = table.number("track_m", b.track_m, 0.1, 3.0);
  b.radius_m = table.number("radius_m", b.radius_m, 0.05, 3.0);
  b.body_height_m = table.number("body_height_m", b.body_height_m, 0.0, 3.0);
  b.max_speed_m_s = table.number("max_speed_m_s", b.max_speed_m_s, 0.05, 5.0);
  b.max_turn_rad_s = table.number("max_turn_rad_s", b.max_turn_rad_s, 0.05, 6.0);
  b.acceleration_m_s2 = table.number("acceleration_m_s2", b.acceleration_m_s2, 0.05, 10.0);
  b.time_constant_s = table.number("time_constant_s", b.time_constant_s, 0.005, 2.0);
  b.command_delay_s = table.number("command_delay_s", b.command_delay_s, 0.0, 1.0);
  return b;
}

HandSetup hand_in(const Table& table) {
  HandSetup h;
  h.speed_m_s = table.number("speed_m_s", h.speed_m_s, 0.1, 3.0);
  h.speed_wander_m_s = table.number("speed_wander_m_s", h.speed_wander_m_s, 0.0, 1.0);
  if (h.speed_wander_m_s >= h.speed_m_s) {
    table.refuse("speed_wander_m_s", "must be less than speed_m_s");
  }
  h.wander_m = table.number("wander_m", h.wander_m, 0.0, 0.1);
  h.lookahead_m = table.number("lookahead_m", h.lookahead_m, 0.15, 2.0);
  return h;
}

BatterySetup battery_in(const Table& table, const std::vector<Station>& stations) {
  constexpr double per_hour = 3600.0;
  constexpr double per_km = 1000.0;
  BatterySetup b;
  b.share = 0.01 * table.number("start_percent", 100 * b.share, 0.0, 100.0);
  b.drains_per_m = 0.01 / per_km * table.number("drains_percent_per_km", 100 * per_km * b.drains_per_m, 0.0, 1000.0);
  b.drains_per_s =
      0.01 / per_hour * table.number("drains_percent_per_h", 100 * per_hour * b.drains_per_s, 0.0, 10'000.0);
  b.charges_per_s =
      0.01 / per_hour * table.number("charges_percent_per_h", 100 * per_hour * b.charges_per_s, 0.0, 100'000.0);
  b.reach_m = table.number("charger_reach_m", b.reach_m, 0.05, 5.0);
  for (const std::string& name : table.texts("chargers", std::vector<std::string>{}, 0, 1000)) {
    const auto station =
        std::find_if(stations.begin(), stations.end(), [&](const Station& one) { return one.name == name; });
    if (station == stations.end()) {
      table.refuse("chargers", "there is no station \"" + name + "\"; name a [[station]]");
    } else {
      b.chargers.push_back({station->site_from_station.x, station->site_from_station.y});
    }
  }
  return b;
}

Disturbances disturbances_in(const Table& table) {
  Disturbances d;
  d.focal_error = 0.01 * table.number("focal_error_percent", 100 * d.focal_error, 0.0, 5.0);
  d.centre_error_px = table.number("principal_point_error_px", d.centre_error_px, 0.0, 20.0);
  d.distortion_error_px = table.number("distortion_error_px", d.distortion_error_px, 0.0, 10.0);
  d.mount_error_m = 1e-3 * table.number("mount_error_mm", 1e3 * d.mount_error_m, 0.0, 50.0);
  d.mount_error_rad = kDegree * table.number("mount_error_deg", in_degrees(d.mount_error_rad), 0.0, 5.0);
  d.vibration_rad = kDegree * table.number("vibration_deg", in_degrees(d.vibration_rad), 0.0, 2.0);
  d.vibration_m = 1e-3 * table.number("vibration_mm", 1e3 * d.vibration_m, 0.0, 20.0);
  d.vibration_low_hz = table.number("vibration_low_hz", d.vibration_low_hz, 0.1, 200.0);
  d.vibration_high_hz = table.number("vibration_high_hz", d.vibration_high_hz, 0.1, 200.0);
  if (d.vibration_high_hz <= d.vibration_low_hz) {
    table.refuse("vibration_high_hz", "must be greater than vibration_low_hz");
  }
  d.exposure_s = 1e-3 * table.number("exposure_ms", 1e3 * d.exposure_s, 0.0, 30.0);
  d.noise_grey = table.number("noise_grey", d.noise_grey, 0.0, 50.0);
  d.vignetting = 0.01 * table.number("vignetting_percent", 100 * d.vignetting, 0.0, 90.0);
  d.exposure_drift = 0.01 * table.number("exposure_drift_percent", 100 * d.exposure_drift, 0.0, 90.0);
  d.dropped_frames = 0.01 * table.number("dropped_frames_percent", 100 * d.dropped_frames, 0.0, 90.0);
  d.time_jitter_s = 1e-3 * table.number("time_jitter_ms", 1e3 * d.time_jitter_s, 0.0, 10.0);
  d.wheel_scale_error = 0.01 * table.number("wheel_scale_percent", 100 * d.wheel_scale_error, 0.0, 20.0);
  d.wheel_asymmetry = 0.01 * table.number("wheel_asymmetry_percent", 100 * d.wheel_asymmetry, 0.0, 20.0);
  d.slip = 0.01 * table.number("slip_percent", 100 * d.slip, 0.0, 20.0);
  d.light_change = 0.01 * table.number("light_change_percent", 100 * d.light_change, 0.0, 90.0);
  d.shadow = 0.01 * table.number("shadow_percent", 100 * d.shadow, 0.0, 100.0);
  d.unevenness_m = 1e-3 * table.number("unevenness_mm", 1e3 * d.unevenness_m, 0.0, 10.0);
  d.rolling_shutter_s = 1e-3 * table.number("rolling_shutter_ms", 1e3 * d.rolling_shutter_s, 0.0, 60.0);
  d.time_offset_s = 1e-3 * table.number("time_offset_ms", 1e3 * d.time_offset_s, -100.0, 100.0);
  return d;
}

/// Reads [change]: what `light` and `wear` name comes first, and each other key overrides or adds to that.
void add_change(const Table& table, Site& site) {
  const std::string light = table.choice("light", light_names().front(), light_names());
  const std::string wear = table.choice("wear", wear_names().front(), wear_names());
  site.change.seed = static_cast<std::uint64_t>(table.integer("seed", 1, 0, INT64_MAX));
  if (auto lit = under_light(site, light)) {
    site = *lit;
  } else {
    table.refuse("light", lit.error().message);
  }
  if (auto worn = with_wear(site, wear)) {
    site = *worn;
  } else {
    table.refuse("wear", worn.error().message);
  }
  site.change = change_in(table, site.change, site.hall.ceiling_m);
  if (2.0 * site.change.sinks_m > site.camera.height_m) {
    table.refuse("sinks_mm", "must be at most half of camera.height_m");
  }
}

}  // namespace

Result<Site> parse_site(std::string_view text, const std::string& file_name) {
  const Table root = config::parse(text, file_name);
  Site site;
  site.name = root.text("name", file_name);
  site.ambient = root.number("ambient", site.ambient, 0.05, 20.0);
  site.floor = floor_in(root.table("floor"));
  site.camera = camera_in(root.table("camera"));
  site.forward_camera = forward_camera_in(root.table("forward_camera"), site.camera);
  site.ceiling_camera = ceiling_camera_in(root.table("ceiling_camera"), {});
  site.stereo_camera = stereo_camera_in(root.table("stereo_camera"), {});
  site.hall = hall_in(root.table("hall"));
  add_solids_in(root, site);
  site.base = base_in(root.table("base"));
  site.hand = hand_in(root.table("hand"));
  site.disturbances = disturbances_in(root.table("disturbances"));
  add_racks(root, site);
  add_walls(root, site);
  add_pillars(root, site);
  add_names_and_lamps(root, site);
  add_overhead_in(root, site);
  if (root.has("battery")) site.battery = battery_in(root.table("battery"), site.stations);
  add_robots(root, site);
  add_blackouts_in(root, site);
  add_change(root.table("change"), site);
  if (auto checked = root.result(); !checked) {
    return fail(checked.error());
  }
  return site;
}

}  // namespace weft::agents::sim
