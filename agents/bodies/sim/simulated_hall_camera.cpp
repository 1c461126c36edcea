#include "agents/bodies/sim/simulated_hall_camera.hpp"

#include "agents/bodies/sim/hall_eye.hpp"

namespace weft::agents::sim {
namespace {

class SimulatedHallCamera final : public SimulatedCamera {
 public:
  SimulatedHallCamera(const Site& site, const HallCameraSetup& setup, std::shared_ptr<const Hall> hall, Random light)
      : sensor_{.id = setup.name, .kind = SensorKind::camera, .camera = setup.given},
        meters_as_seen_(setup.meters_as_seen),
        exposure_(setup.exposure, site.disturbances.exposure_s),
        eye_(site, setup.actual, setup.options, std::move(hall), light) {}

  const Sensor& sensor() const override { return sensor_; }
  void light_up(Random random) override { eye_.light_up(random); }

  Seen look(const Moment& moment) override {
    exposure_.comes(moment.time_s);
    exposed_ = exposure_.now();
    HallImage taken = eye_.take(moment, exposure_, moment.noise_seed);
    exposure_.taken(meters_as_seen_ ? taken.mean_grey / exposure_.gain() : taken.mean_light * moment.brightness);
    return eye_.image_of(taken);
  }
  std::optional<Exposure> exposed() const override { return exposed_; }
  bool expose(const Exposure& exposure) override { return exposure_.tell(exposure); }

 private:
  Sensor sensor_;
  bool meters_as_seen_;
  ExposureControl exposure_;
  Exposure exposed_;  // the last image
  HallEye eye_;
};

}  // namespace

std::unique_ptr<SimulatedCamera> make_hall_camera(const Site& site, const HallCameraSetup& setup,
                                                  std::shared_ptr<const Hall> hall, Random light) {
  return std::make_unique<SimulatedHallCamera>(site, setup, std::move(hall), light);
}

}  // namespace weft::agents::sim
