#include <cmath>

#include "agents/bodies/sim/calibration.hpp"
#include "agents/bodies/sim/hall/exposure_control.hpp"
#include "agents/bodies/sim/hall/hall_camera.hpp"
#include "agents/bodies/sim/readout.hpp"
#include "agents/bodies/sim/simulated_camera.hpp"

namespace weft::agents::sim {
namespace {

/// Sets the times of the samples as shares of the exposure, from its middle, in order: the middles of its quarters.
constexpr std::array<double, kHallSamples> kSampleTime = {-0.375, -0.125, 0.125, 0.375};

/// Returns the camera as agents are told it: a focal length from a data sheet and where it was screwed on. Nobody has
/// measured its lens, on any day.
CameraModel given_camera(const ForwardCameraSetup& setup, const CameraOwner& owner) {
  CameraModel camera;
  camera.id = owner.robot + "/forward";
  camera.width = setup.width;
  camera.height = setup.height;
  camera.fx = camera.fy = setup.focal_px;
  camera.cx = (setup.width - 1) / 2.0;
  camera.cy = (setup.height - 1) / 2.0;
  camera.robot_from_camera = downward_mount(setup.forward_m, setup.left_m, setup.height_m, setup.pitch_rad, 0.0, 0.0);
  return camera;
}

CameraModel true_camera(CameraModel camera, const Site& site, const CameraOwner& owner) {
  camera = true_camera_from(camera, site.disturbances, site.change.sinks_m, owner.camera);
  camera.distortion = {site.forward_camera.k1, 0.0, 0.0, 0.0, 0.0};
  return camera;
}

class SimulatedForwardCamera final : public SimulatedCamera {
 public:
  SimulatedForwardCamera(const Site& site, const CameraOwner& owner, const FloorSource& floor,
                         const Photographed& photographed, Random light)
      : site_(site),
        given_(given_camera(site.forward_camera, owner)),
        true_(true_camera(given_, site, owner)),
        exposure_(site.forward_camera, site.disturbances.exposure_s),
        camera_(true_, {site.disturbances.vignetting, site.forward_camera.headlight},
                std::make_shared<const Hall>(site, floor, photographed), site.movers, HallLight(site, light)) {}

  std::string name() const override { return "forward"; }
  const CameraModel& given() const override { return given_; }
  void light_up(Random random) override { camera_.set_light(HallLight(site_, random)); }

  Image look(const Moment& moment) override {
    exposure_.comes(moment.time_s);
    exposed_ = exposure_.now();
    HallShot shot;
    shot.site_from_camera = poses_at(moment, 0.0);
    if (const double readout_s = site_.disturbances.rolling_shutter_s; readout_s > 0.0) {
      for (int band = 0; band < true_.height / kHallBand; ++band) {
        const double middle_row = kHallBand * band + (kHallBand - 1) / 2.0;
        shot.bands.push_back(poses_at(moment, row_time_s(middle_row, true_.height, readout_s)));
      }
    }
    shot.time_s = moment.time_s;
    shot.gain = exposure_.gain() * moment.brightness;
    shot.noise_grey = site_.disturbances.noise_grey * std::sqrt(exposure_.amplified());
    shot.noise_seed = moment.noise_seed;
    HallImage taken = camera_.take(shot);
    exposure_.taken(taken.mean_light * moment.brightness);
    return {true_.width, true_.height, std::make_shared<const Bytes>(std::move(taken.grey))};
  }
  std::optional<Exposure> exposed() const override { return exposed_; }
  bool expose(const Exposure& exposure) override { return exposure_.tell(exposure); }

 private:
  /// Returns where the camera is for rows that are taken so much later than the image's middle.
  std::array<Pose3, kHallSamples> poses_at(const Moment& moment, double later_s) const {
    std::array<Pose3, kHallSamples> poses;
    for (std::size_t k = 0; k < kHallSamples; ++k)
      poses[k] = moment.site_from_camera(true_.robot_from_camera, later_s + kSampleTime[k] * exposure_.exposure_s());
    return poses;
  }

  Site site_;
  CameraModel given_;
  CameraModel true_;
  ExposureControl exposure_;
  Exposure exposed_;  // the last image
  HallCamera camera_;
};

}  // namespace

std::unique_ptr<SimulatedCamera> make_forward_camera(const Site& site, const CameraOwner& owner,
                                                     const std::shared_ptr<const FloorSource>& floor,
                                                     const Photographed& photographed, Random light) {
  return std::make_unique<SimulatedForwardCamera>(site, owner, *floor, photographed, light);
}

}  // namespace weft::agents::sim
