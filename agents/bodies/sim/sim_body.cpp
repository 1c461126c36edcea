#include "agents/bodies/sim/sim_body.hpp"

#include <algorithm>
#include <cmath>

#include "agents/bodies/sim/base.hpp"
#include "agents/bodies/sim/blacked_out_camera.hpp"
#include "agents/bodies/sim/floor/site_floor.hpp"
#include "agents/bodies/sim/hall/hall_photographs.hpp"
#include "agents/bodies/sim/hand.hpp"
#include "agents/bodies/sim/relief.hpp"
#include "agents/bodies/sim/simulated_camera.hpp"
#include "agents/bodies/sim/stance.hpp"
#include "agents/bodies/sim/truth.hpp"
#include "agents/bodies/sim/wave.hpp"

namespace weft::agents::sim {
namespace {

/// Names streams of randomness, so that more of one does not change another.
enum Part : std::uint64_t { wheels = 1, calibration, slip, vibration, exposure, timing, hand, light, noise };

std::uint64_t seed_of(std::uint64_t seed, const RobotStart& robot) {
  std::uint64_t h = 0xcbf29ce484222325ULL ^ (seed * 0x9E3779B97F4A7C15ULL);
  for (const char c : robot.name) {
    h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  }
  return h ^ (robot.seed * 0xC2B2AE3D27D4EB4FULL);
}

Random random_of(std::uint64_t robot_seed, Part part, std::uint64_t more = 0) {
  return Random(robot_seed).fork(part).fork(more);
}

struct Shake {
  Wave pitch, roll, height;
};
Shake shake_from(const Disturbances& d, Random random) {
  const auto wave = [&](double rms, std::uint64_t stream) {
    return Wave(d.vibration_low_hz, d.vibration_high_hz, rms, random.fork(stream));
  };
  return {wave(d.vibration_rad, 1), wave(d.vibration_rad, 2), wave(d.vibration_m, 3)};
}

/// Holds a camera and its rhythm.
struct TimedCamera {
  std::unique_ptr<SimulatedCamera> camera;
  double fps = 0.0, fps_at_rest = 0.0;
  double last_s = 0.0;

  double period_s(bool at_rest) const { return 1.0 / (at_rest ? fps_at_rest : fps); }
  /// Returns the time until its next image, in seconds.
  double wait_s(double now_s, bool at_rest) const {
    return std::max(1e-3, last_s == now_s ? period_s(at_rest) : last_s + period_s(at_rest) - now_s);
  }
};

class SimBody final : public SimulatedBody {
 public:
  SimBody(const SimBodyConfig& config, const RobotStart& start, const std::shared_ptr<const FloorSource>& floor,
          const Photographed& hall, std::optional<TruthFile> truth);

  Result<Sample> step(const Twist& command) override;
  Result<void> drive_by_hand(const std::vector<SitePoint>& along) override;
  void stop_hand() override;
  Result<void> expose(const std::string& sensor, const Exposure& exposure) override;
  void put(const Pose2& site_from_robot, const Twist& moving) override;
  Pose2 site_from_robot() const override { return base_.site_from_robot(); }
  Rig rig() const override;
  std::string kind() const override { return "sim"; }

 private:
  bool at_rest(const Twist& command) const;
  Random light_now() const;
  void next_run();
  Moment moment_now();
  TimedCamera& next_camera(bool at_rest);
  Duration stamp_now();
  View view_now(SimulatedCamera& camera, SensorTime time);

  std::uint64_t hands_ = 0;
  std::uint64_t run_ = 0;  ///< one more when a hand begins or ends: another light, as teach and repeat have
  std::uint64_t frame_ = 0;
  double now_s_ = 0.0;
  Duration last_stamp_{};
  Site site_;
  std::uint64_t seed_ = 0;
  std::uint64_t day_ = 0;
  std::string robot_;
  Base base_;
  Shake shake_;
  std::optional<Relief> relief_;  ///< none: the floor is a plane
  BoundedWave exposure_drift_;
  Random timing_;
  std::vector<TimedCamera> cameras_;
  std::optional<TruthFile> truth_;
  std::optional<Hand> hand_;
  bool hand_done_ = false;
  std::optional<Battery> battery_;
};

SimBody::SimBody(const SimBodyConfig& config, const RobotStart& start,
                 const std::shared_ptr<const FloorSource>& floor, const Photographed& hall,
                 std::optional<TruthFile> truth)
    : site_(config.site),
      seed_(seed_of(config.seed, start)),
      day_(config.day),
      robot_(start.name),
      base_(site_.base, site_.disturbances, Solids(site_),
            wheel_errors_from(site_.disturbances, random_of(seed_, wheels)), start.site_from_robot,
            random_of(seed_, slip, day_)),
      shake_(shake_from(site_.disturbances, random_of(seed_, vibration, day_))),
      relief_(relief_of(site_)),
      exposure_drift_(1.0 / 60.0, 1.0 / 8.0, site_.disturbances.exposure_drift / 2, random_of(seed_, exposure, day_)),
      timing_(random_of(seed_, timing, day_)),
      truth_(std::move(truth)) {
  const CameraOwner owner{robot_, day_, random_of(seed_, calibration, day_), random_of(seed_, calibration)};
  if (site_.battery) battery_.emplace(*site_.battery);
  const auto looks = [&start](Gaze gaze) {
    return std::find(start.looks.begin(), start.looks.end(), gaze) != start.looks.end();
  };
  if (looks(Gaze::down)) {
    const CameraSetup& camera = site_.camera;
    cameras_.push_back({make_floor_camera(site_, owner, floor, light_now()), camera.fps, camera.fps_at_rest, 0.0});
  }
  if (looks(Gaze::ahead)) {
    const ForwardCameraSetup& camera = site_.forward_camera;
    cameras_.push_back(
        {make_forward_camera(site_, owner, floor, hall, light_now()), camera.fps, camera.fps_at_rest, 0.0});
  }
  if (looks(Gaze::up)) {
    const CeilingCameraSetup& camera = site_.ceiling_camera;
    cameras_.push_back(
        {make_ceiling_camera(site_, owner, floor, hall, light_now()), camera.fps, camera.fps_at_rest, 0.0});
  }
  if (start.has_stereo) {
    const StereoCameraSetup& camera = site_.stereo_camera;
    cameras_.push_back(
        {make_stereo_camera(site_, owner, floor, hall, light_now()), camera.fps, camera.fps_at_rest, 0.0});
  }
  for (TimedCamera& timed : cameras_) timed.camera = with_blackouts(std::move(timed.camera), site_);
  constexpr double apart = 0.4;  // of a period: no two cameras see at the same moment
  for (std::size_t i = 1; i < cameras_.size(); ++i)
    cameras_[i].last_s = -apart * static_cast<double>(i) * cameras_[i].period_s(false);
}

Rig SimBody::rig() const {
  Rig rig;
  for (const TimedCamera& timed : cameras_) rig.sensors.push_back(timed.camera->sensor());
  return rig;
}

Random SimBody::light_now() const {
  return random_of(seed_, light, day_ * 0x10000 + run_);
}

void SimBody::next_run() {
  ++run_;
  for (const TimedCamera& timed : cameras_) timed.camera->light_up(light_now());
}

Result<void> SimBody::drive_by_hand(const std::vector<SitePoint>& along) {
  auto led = Hand::along(along, site_, base_.site_from_robot(), random_of(seed_, hand, day_ * 0x10000 + hands_));
  if (!led) {
    return fail(led.error());
  }
  hand_ = std::move(*led);
  hand_done_ = false;
  ++hands_;
  next_run();
  return {};
}

void SimBody::stop_hand() {
  if (hand_) {
    hand_.reset();
    next_run();
  }
  hand_done_ = false;
}

Result<void> SimBody::expose(const std::string& sensor, const Exposure& exposure) {
  const auto looks = std::find_if(cameras_.begin(), cameras_.end(),
                                  [&](const TimedCamera& timed) { return timed.camera->sensor().id == sensor; });
  if (looks == cameras_.end()) return fail(ErrorCode::not_found, "there is no sensor " + sensor);
  if (!looks->camera->expose(exposure))
    return fail(ErrorCode::refused, "sensor " + sensor + " exposes as it is built to");
  return {};
}

void SimBody::put(const Pose2& site_from_robot, const Twist& moving) {
  hand_.reset();
  hand_done_ = false;
  base_.put(site_from_robot, moving);
  next_run();
}

bool SimBody::at_rest(const Twist& command) const {
  return !hand_ && command == Twist{} && base_.at_rest();
}

Moment SimBody::moment_now() {
  const Twist moving = base_.velocity();
  // Standing still nothing shakes; from a slow walk on everything does.
  const double shaking = std::min(1.0, (std::abs(moving.linear_m_s) + 0.3 * std::abs(moving.angular_rad_s)) / 0.2);
  Moment moment;
  // An image that is stamped now was taken this much earlier.
  const double offset_s = site_.disturbances.time_offset_s;
  const auto robot_at = [this, moving](double from_now_s) {
    return base_.site_from_robot() *
           se2_exp(Eigen::Vector3d(moving.linear_m_s * from_now_s, 0.0, moving.angular_rad_s * from_now_s));
  };
  moment.site_from_camera = [this, robot_at, offset_s, shaking](Pose3 robot_from_camera, double from_taken_s) {
    const double from_now_s = from_taken_s - offset_s;
    const double t = now_s_ + from_now_s;
    robot_from_camera.translation.z() += shaking * shake_.height.at(t);
    const Eigen::AngleAxisd pitch(shaking * shake_.pitch.at(t), Eigen::Vector3d::UnitY());
    const Eigen::AngleAxisd roll(shaking * shake_.roll.at(t), Eigen::Vector3d::UnitX());
    robot_from_camera.rotation = (roll * pitch * robot_from_camera.rotation).normalized();
    const Pose2 site_from_robot = robot_at(from_now_s);
    return (relief_ ? stance_on(*relief_, site_.base, site_from_robot) : lift(site_from_robot)) * robot_from_camera;
  };
  moment.site_from_robot = robot_at(-offset_s);
  moment.time_s = std::max(0.0, now_s_ - offset_s);
  moment.waited_s = base_.solids().waited_s();
  moment.brightness = 1.0 + exposure_drift_.at(now_s_);
  moment.noise_seed = random_of(seed_, noise, day_ * 0x10000 + run_).fork(frame_).next();
  return moment;
}

Duration SimBody::stamp_now() {
  const double jitter = std::clamp(timing_.normal(), -3.0, 3.0) * site_.disturbances.time_jitter_s;
  // Stamps never run backwards, however large the jitter of a site file.
  return std::max(last_stamp_ + std::chrono::microseconds(100), from_seconds(now_s_ + jitter));
}

View SimBody::view_now(SimulatedCamera& camera, SensorTime time) {
  View view;
  view.frame = frame_;
  view.time = time;
  view.sensor = camera.sensor().id;
  view.calibration = camera.sensor().camera.id;
  view.data = camera.look(moment_now());
  view.exposure = camera.exposed();
  return view;
}

TimedCamera& SimBody::next_camera(bool at_rest) {
  return *std::min_element(cameras_.begin(), cameras_.end(), [&](const TimedCamera& a, const TimedCamera& b) {
    return a.wait_s(now_s_, at_rest) < b.wait_s(now_s_, at_rest);
  });
}

Result<Sample> SimBody::step(const Twist& command) {
  Sample sample;
  const Twist own = battery_ && battery_->is_empty() ? Twist{} : command;
  sample.motion.command = hand_ ? hand_->command(base_.site_from_robot(), now_s_) : own;
  TimedCamera& looks = next_camera(at_rest(command));
  const double period_s = looks.wait_s(now_s_, at_rest(command));
  base_.advance(sample.motion.command, period_s);
  now_s_ += period_s;
  looks.last_s = now_s_;
  ++frame_;
  const Duration stamp = stamp_now();
  sample.motion.elapsed = stamp - last_stamp_;
  const WheelStep rolled = base_.take_wheel_step();
  if (site_.base.has_encoders) sample.motion.wheels = rolled;
  if (battery_) {
    const Pose2 here = base_.site_from_robot();
    battery_->advance(rolled.distance_m, period_s, {here.x, here.y});
    sample.charge = battery_->charge();
  }
  last_stamp_ = stamp;
  sample.frame = frame_;
  sample.time = SensorTime(stamp);
  sample.hand = hand_.has_value();
  if (hand_ && hand_->at_end() && base_.at_rest()) {
    hand_.reset();
    hand_done_ = true;
  }
  sample.hand_done = hand_done_;
  const bool dropped = timing_.chance(site_.disturbances.dropped_frames);
  if (!dropped) {
    sample.views.push_back(view_now(*looks.camera, sample.time));
  }
  if (sample.hand && hand_done_) {
    next_run();
  }
  const std::optional<std::string> touch = base_.take_touch();
  if (truth_) {
    if (auto written = truth_->write(robot_, frame_, now_s_, base_.site_from_robot(), touch); !written) {
      return fail(written.error());
    }
  }
  return sample;
}

Result<RobotStart> find_robot(const Site& site, const std::string& name) {
  std::string names;
  for (const RobotStart& robot : site.robots) {
    if (robot.name == name) {
      return robot;
    }
    names += (names.empty() ? "" : ", ") + robot.name;
  }
  return fail(ErrorCode::not_found, "site " + site.name + " has no robot \"" + name + "\"; there are " + names);
}

}  // namespace

Result<std::unique_ptr<SimulatedBody>> make_sim_body(const SimBodyConfig& config) {
  auto start = find_robot(config.site, config.robot);
  if (!start) {
    return fail(start.error());
  }
  SimBodyConfig now = config;
  if (now.day < now.site.change.from_day) now.site.change = {};
  std::erase_if(now.site.obstacles, [&now](const Obstacle& obstacle) { return now.day < obstacle.from_day; });
  if (start->ceiling_camera) now.site.ceiling_camera = *start->ceiling_camera;
  auto floor = make_site_floor(now.site, now.floors_dir, now.warn);
  if (!floor) {
    return fail(floor.error());
  }
  Photographed hall;
  if (config.hall_dir) {
    auto photographed = read_hall_photographs(*config.hall_dir);
    if (!photographed) {
      return fail(photographed.error());
    }
    hall = std::move(*photographed);
  }
  std::optional<TruthFile> truth;
  if (config.truth_path) {
    auto opened = TruthFile::open(*config.truth_path);
    if (!opened) {
      return fail(opened.error());
    }
    truth = std::move(*opened);
  }
  return std::unique_ptr<SimulatedBody>(std::make_unique<SimBody>(now, *start, *floor, hall, std::move(truth)));
}

}  // namespace weft::agents::sim
