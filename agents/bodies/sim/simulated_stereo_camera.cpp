#include <algorithm>
#include <cmath>

#include "agents/bodies/sim/calibration.hpp"
#include "agents/bodies/sim/hall_eye.hpp"

namespace weft::agents::sim {
namespace {

constexpr std::uint64_t kErrorsOfPair =
    4;  // stream of a robot's camera errors: others than those of its other cameras
constexpr std::uint64_t kNoiseOfRight = 0x9E3779B97F4A7C15ULL;

struct Pair {
  CameraModel left;
  CameraModel right;
};

/// Draws an error of that RMS, without the one draw in 400 that lies beyond three times that.
double drawn(double rms, Random& random) {
  return rms * std::clamp(random.normal(), -3.0, 3.0);
}

/// Puts the right camera beside the left one: in the left camera's frame, x is to the right.
CameraModel beside(const CameraModel& left, double baseline_m, const Eigen::Quaterniond& left_from_right) {
  CameraModel right = left;
  right.robot_from_camera = left.robot_from_camera * Pose3{left_from_right, Eigen::Vector3d(baseline_m, 0.0, 0.0)};
  return right;
}

/// Returns the pair as agents are told it: rectified, measured anew each day.
Pair given_pair(const StereoCameraSetup& setup, const Disturbances& disturbances, const CameraOwner& owner) {
  Pair pair;
  CameraModel& left = pair.left;
  left.width = setup.width;
  left.height = setup.height;
  left.fx = left.fy = setup.focal_px;
  left.cx = (setup.width - 1) / 2.0;
  left.cy = (setup.height - 1) / 2.0;
  left.robot_from_camera = downward_mount(setup.forward_m, setup.left_m + setup.baseline_m / 2.0, setup.height_m,
                                          setup.pitch_rad, 0.0, 0.0);
  left.sigma = stated_sigma(disturbances, setup.focal_px);
  left.sigma.focal_share = std::max(1e-6, setup.focal_error);
  pair.right = beside(left, setup.baseline_m, Eigen::Quaterniond::Identity());
  const std::string id = owner.robot + "/stereo/day" + std::to_string(owner.day);
  left.id = id + "/left";
  pair.right.id = id + "/right";
  return pair;
}

/// Returns the pair as it is: the mount and the lenses are off together, and the right camera against the left one.
Pair true_pair(const Pair& given, const Site& site, Random random) {
  const StereoCameraSetup& setup = site.stereo_camera;
  Random errors = random.fork(kErrorsOfPair);
  Disturbances of_mount = site.disturbances;
  of_mount.focal_error = setup.focal_error;
  of_mount.centre_error_px = of_mount.distortion_error_px = 0.0;  // a rectified pair has its centres where it says
  Pair pair;
  pair.left = true_camera_from(given.left, of_mount, site.change.sinks_m, errors.fork(1));
  pair.left.distortion = {setup.k1, 0.0, 0.0, 0.0, 0.0};
  const double longer = 1.0 + drawn(setup.baseline_error, errors);
  const Eigen::AngleAxisd pitch(drawn(setup.relative_pitch_error_rad, errors), Eigen::Vector3d::UnitX());
  const Eigen::AngleAxisd yaw(drawn(setup.relative_yaw_error_rad, errors), Eigen::Vector3d::UnitY());
  pair.right = beside(pair.left, setup.baseline_m * longer, Eigen::Quaterniond(pitch * yaw));
  return pair;
}

/// Is two cameras in one hall behind one shutter: one moment, one exposure, which the left one meters; noise apart.
class SimulatedStereoCamera final : public SimulatedCamera {
 public:
  SimulatedStereoCamera(const Site& site, const Pair& given, const Pair& actual,
                        const std::shared_ptr<const Hall>& hall, Random light)
      : sensor_{.id = "stereo", .kind = SensorKind::stereo, .camera = given.left, .right = given.right},
        exposure_(site.stereo_camera, site.disturbances.exposure_s),
        left_(site, actual.left, options_of(site), hall, light),
        right_(site, actual.right, options_of(site), hall, light) {}

  const Sensor& sensor() const override { return sensor_; }
  void light_up(Random random) override {
    left_.light_up(random);
    right_.light_up(random);
  }
  Seen look(const Moment& moment) override {
    exposure_.comes(moment.time_s);
    exposed_ = exposure_.now();
    HallImage left = left_.take(moment, exposure_, moment.noise_seed);
    HallImage right = right_.take(moment, exposure_, moment.noise_seed ^ kNoiseOfRight);
    exposure_.taken(left.mean_light * moment.brightness);
    return StereoPair{left_.image_of(left), right_.image_of(right)};
  }
  std::optional<Exposure> exposed() const override { return exposed_; }
  bool expose(const Exposure& exposure) override { return exposure_.tell(exposure); }

 private:
  static HallCameraOptions options_of(const Site& site) { return {.vignetting = site.disturbances.vignetting}; }

  Sensor sensor_;
  ExposureControl exposure_;
  Exposure exposed_;  // the last pair
  HallEye left_;
  HallEye right_;
};

}  // namespace

std::unique_ptr<SimulatedCamera> make_stereo_camera(const Site& site, const CameraOwner& owner,
                                                    const std::shared_ptr<const FloorSource>& floor,
                                                    const Photographed& photographed, Random light) {
  const Pair given = given_pair(site.stereo_camera, site.disturbances, owner);
  const Pair actual = true_pair(given, site, owner.calibration);
  return std::make_unique<SimulatedStereoCamera>(site, given, actual,
                                                 std::make_shared<const Hall>(site, *floor, photographed), light);
}

}  // namespace weft::agents::sim
