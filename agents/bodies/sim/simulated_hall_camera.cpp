#include "agents/bodies/sim/simulated_hall_camera.hpp"

#include <cmath>

#include "agents/bodies/sim/hall/exposure_control.hpp"
#include "agents/bodies/sim/readout.hpp"

namespace weft::agents::sim {
namespace {

/// Sets the times of the samples as shares of the exposure, from its middle, in order: the middles of its quarters.
constexpr std::array<double, kHallSamples> kSampleTime = {-0.375, -0.125, 0.125, 0.375};

class SimulatedHallCamera final : public SimulatedCamera {
 public:
  SimulatedHallCamera(const Site& site, const HallCameraSetup& setup, std::shared_ptr<const Hall> hall, Random light)
      : site_(site),
        name_(setup.name),
        given_(setup.given),
        true_(setup.actual),
        meters_as_seen_(setup.meters_as_seen),
        exposure_(setup.exposure, site.disturbances.exposure_s),
        camera_(true_, setup.options, std::move(hall), site.movers, HallLight(site, light)) {}

  std::string name() const override { return name_; }
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
    exposure_.taken(meters_as_seen_ ? taken.mean_grey / exposure_.gain() : taken.mean_light * moment.brightness);
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
  std::string name_;
  CameraModel given_;
  CameraModel true_;
  bool meters_as_seen_;
  ExposureControl exposure_;
  Exposure exposed_;  // the last image
  HallCamera camera_;
};

}  // namespace

std::unique_ptr<SimulatedCamera> make_hall_camera(const Site& site, const HallCameraSetup& setup,
                                                  std::shared_ptr<const Hall> hall, Random light) {
  return std::make_unique<SimulatedHallCamera>(site, setup, std::move(hall), light);
}

}  // namespace weft::agents::sim
