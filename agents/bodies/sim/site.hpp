#pragma once
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agents/bodies/battery.hpp"
#include "agents/bodies/body.hpp"
#include "agents/bodies/sim/blackout.hpp"
#include "agents/bodies/sim/ceiling.hpp"
#include "agents/bodies/sim/ceiling_camera_setup.hpp"
#include "agents/bodies/sim/change.hpp"
#include "agents/bodies/sim/exposure_setup.hpp"
#include "agents/bodies/sim/obstacle.hpp"
#include "agents/bodies/sim/stereo_camera_setup.hpp"
#include "core/geometry/pose2.hpp"
#include "core/result.hpp"

/// Describes a simulated warehouse as its site file has it; docs/simulation.md has every key with unit, bound and
/// default. Site frame: x, y on the floor, z up; metres and radians here, whatever the file's units are.
namespace weft::agents::sim {

/// Stands on the floor; its frame's origin is its middle, `length_m` along its heading.
struct Box {
  enum class Kind : std::uint8_t { rack, wall, pillar };
  Kind kind = Kind::rack;
  std::string name;
  Pose2 site_from_box;
  double length_m = 1.0;
  double width_m = 1.0;
  double height_m = 2.0;
  double contrast = 1.0;  ///< of a wall: factor on its texture about its mean
  bool has_signs = true;  ///< of a wall
  std::string like = {};  ///< of a rack: the name of the one before it that shows the same; empty: none
};

struct Station {
  std::string name;
  Pose2 site_from_station;
};

struct Lamp {
  double x = 0.0;
  double y = 0.0;
  double height_m = 6.0;
  double brightness = 1.0;  ///< 1: a lamp that lights the floor under it to twice the ambient light
  double flicker = 0.0;     ///< most of its light that is missing at a time
  double flicker_hz = 8.0;  ///< so often another share is missing
  double ends_s = std::numeric_limits<double>::infinity();  ///< of a body's time: dark from then on
};

struct RobotStart {
  std::string name;
  Pose2 site_from_robot;
  std::uint64_t seed = 0;                  ///< added to the run's seed: other wheels, another calibration
  std::vector<Gaze> looks = {Gaze::down};  ///< a camera each
  bool has_stereo = false;                 ///< a pair that looks ahead
  std::optional<CeilingCameraSetup> ceiling_camera = {};  ///< its own; none: the site's
};

struct FloorSetup {
  double x_min = 0.0, y_min = 0.0, x_max = 20.0, y_max = 12.0;
  std::string material = "concrete";
  std::string photograph;  ///< with a folder of photographs: only this one (file name without ending); empty: all
  std::uint64_t seed = 1;
  double brightness = 125.0;  ///< mean grey level under mean light
  double contrast = 1.0;      ///< factor on the material's own
  double gloss = 1.0;         ///< factor on the material's own
  double cache_mb = 160.0;    ///< tiles kept, megabytes of 10^6 bytes
};

struct CameraSetup {
  int width = 752, height = 480;
  double focal_px = 460.0;
  double cx_px = 375.5, cy_px = 239.5;
  double k1 = -0.08, k2 = 0.01, p1 = 0.0004, p2 = -0.0003, k3 = 0.0;
  double height_m = 0.6, forward_m = 0.25, left_m = 0.0, pitch_rad = 0.735;
  double fps = 30.0, fps_at_rest = 2.0;
};

/// Describes a camera that looks ahead over the floor; agents are told its focal length and mount, and no more.
struct ForwardCameraSetup : ExposureSetup {
  int width = 320, height = 240;
  double focal_px = 386.0;  ///< 45 degrees of view, as the camera of Krajnik et al. 2018
  double k1 = -0.05;
  double height_m = 0.35, forward_m = 0.15, left_m = 0.0, pitch_rad = -0.05;  ///< pitch down from level
  double headlight = 0.0;  ///< light on what is 2 m ahead, 1: as the floor's mean
  double fps = 30.0, fps_at_rest = 2.0;
};

/// Describes the part of a hall that the floor camera does not see.
struct HallSetup {
  double ceiling_m = 7.0;
  double ceiling_grey = 95.0, wall_grey = 125.0;  ///< under mean light
  CeilingSetup ceiling;
};

/// Describes somebody who walks or drives to and fro.
struct Mover {
  enum class Kind : std::uint8_t { person, forklift };
  Kind kind = Kind::person;
  std::vector<SitePoint> way;
  double speed_m_s = 1.0;
  double begins_m = 0.0;  ///< along the way when a body's time begins
  double forks_m = 0.15;  ///< a forklift's, above the floor
  std::string name = "mover";
  bool is_rude = false;  ///< a person who does not wait for robots
  bool is_solid = true;  ///< false: robots go through it, and it does not wait for them
};

struct BaseSetup {
  double track_m = 0.42;   ///< between the wheels
  double radius_m = 0.28;  ///< footprint; the body stops at a box
  double body_height_m = 0.5;
  double max_speed_m_s = 1.0, max_turn_rad_s = 1.5;
  double acceleration_m_s2 = 0.8;  ///< of each wheel's rim
  double time_constant_s = 0.08;   ///< first-order lag of the wheel speed
  double command_delay_s = 0.06;
  bool has_encoders = true;  ///< false: nobody is told how far its wheels have turned
};

struct HandSetup {
  double speed_m_s = 0.55;
  double speed_wander_m_s = 0.15;  ///< largest deviation
  double wander_m = 0.04;          ///< largest deviation of the path it aims at
  double lookahead_m = 0.45;
};

/// Sets the sizes of all disturbances; every default is the least that a demonstration has to stand.
struct Disturbances {
  double focal_error = 0.003;        ///< RMS of true / given - 1; drawn by robot and day, as the four below
  double centre_error_px = 1.0;      ///< RMS, of the optical centre, across and down each
  double distortion_error_px = 0.5;  ///< RMS, of where the lens puts the ray of the image's corner
  double mount_error_m = 0.003;      ///< RMS of the offset's length, the same in every direction
  double mount_error_rad = 0.3 * 0.017453292519943295;  ///< likewise, of the turn
  double vibration_rad = 0.05 * 0.017453292519943295;   ///< RMS of pitch and of roll, while moving
  double vibration_m = 0.001;                           ///< RMS of height
  double vibration_low_hz = 5.0, vibration_high_hz = 20.0;
  double exposure_s = 0.005;        ///< motion during it blurs
  double noise_grey = 2.0;          ///< standard deviation
  double vignetting = 0.2;          ///< loss in the corners
  double exposure_drift = 0.2;      ///< peak to peak, share of the mean
  double dropped_frames = 0.005;    ///< probability
  double time_jitter_s = 0.001;     ///< standard deviation of the time stamp, cut at three
  double wheel_scale_error = 0.03;  ///< at least; up to a fifth more, sign and size by robot
  double wheel_asymmetry = 0.02;    ///< right against left, likewise
  double slip = 0.01;               ///< standard deviation of each wheel's slip
  double light_change = 0.15;       ///< each lamp's brightness, by day and from run to run
  double shadow = 1.0;              ///< 0: the robot casts none
  double unevenness_m = 0.0;        ///< greatest deviation of the floor from its plane
  double rolling_shutter_s = 0.0;   ///< from the first row of an image to the last
  double time_offset_s = 0.0;       ///< an image's stamp less the time at which it was taken
};

struct Site {
  std::string name;
  FloorSetup floor;
  std::vector<Box> boxes;
  std::vector<Station> stations;
  std::vector<Lamp> lamps;
  double ambient = 1.0;  ///< light that comes from everywhere
  std::vector<RobotStart> robots;
  CameraSetup camera;
  ForwardCameraSetup forward_camera;
  CeilingCameraSetup ceiling_camera;
  StereoCameraSetup stereo_camera;
  HallSetup hall;
  std::vector<Duct> ducts;
  std::vector<Pipe> pipes;
  std::vector<Skylight> skylights;
  std::vector<Mover> movers;
  std::vector<Obstacle> obstacles;
  std::vector<Blackout> blackouts;
  BaseSetup base;
  HandSetup hand;
  std::optional<BatterySetup> battery;  ///< of every robot; none: they have none
  Disturbances disturbances;
  Change change;
};

/// Parses the text of a site file. invalid: names file, line, key and bound.
Result<Site> parse_site(std::string_view text, const std::string& file_name);

}  // namespace weft::agents::sim
