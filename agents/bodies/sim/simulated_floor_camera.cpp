#include "agents/bodies/sim/calibration.hpp"
#include "agents/bodies/sim/camera.hpp"
#include "agents/bodies/sim/readout.hpp"
#include "agents/bodies/sim/simulated_camera.hpp"

namespace weft::agents::sim {
namespace {

CameraOptions options_of(const Site& site) {
  return {.vignetting = site.disturbances.vignetting,
          .noise_grey = site.disturbances.noise_grey,
          .shadow = site.disturbances.shadow,
          .lens_spots = site.change.lens_spots,
          .lens_depth = site.change.lens_depth,
          .lens_seed = site.change.seed,
          .cache_bytes = static_cast<std::size_t>(site.floor.cache_mb * 1e6),
          .relief = relief_of(site)};
}

class SimulatedFloorCamera final : public SimulatedCamera {
 public:
  SimulatedFloorCamera(const Site& site, const CameraOwner& owner, std::shared_ptr<const FloorSource> floor,
                       Random light)
      : site_(site),
        sensor_{.id = "floor",
                .kind = SensorKind::camera,
                .camera = given_camera_from(site.camera, site.disturbances, owner.robot, owner.day)},
        true_(true_camera_from(sensor_.camera, site.disturbances, site.change.sinks_m, owner.calibration)),
        gloss_(floor->gloss()),
        camera_(true_, options_of(site), std::move(floor), std::make_shared<const Scene>(site.boxes),
                Light(site, gloss_, light)) {}

  const Sensor& sensor() const override { return sensor_; }
  void light_up(Random random) override { camera_.set_light(Light(site_, gloss_, random)); }

  Seen look(const Moment& moment) override {
    FloorShot shot;
    const FloorShot::Row middle = row_at(moment, 0.0);
    shot.site_from_camera = middle.site_from_camera;
    shot.site_from_camera_mid = middle.site_from_camera_mid;
    if (const double readout_s = site_.disturbances.rolling_shutter_s; readout_s > 0.0) {
      for (int v = 0; v < true_.height; ++v)
        shot.rows.push_back(row_at(moment, row_time_s(v, true_.height, readout_s)));
    }
    shot.body = {moment.site_from_robot.x, moment.site_from_robot.y, site_.base.radius_m, site_.base.body_height_m};
    shot.gain = moment.brightness;
    shot.time_s = moment.time_s;
    shot.noise_seed = moment.noise_seed;
    return Image{true_.width, true_.height, std::make_shared<const Bytes>(camera_.render(shot))};
  }

 private:
  /// Returns where the camera is for a row that is taken so much later than the image's middle.
  FloorShot::Row row_at(const Moment& moment, double later_s) const {
    FloorShot::Row row;
    for (std::size_t k = 0; k < kSubsamples; ++k) {
      row.site_from_camera[k] = moment.site_from_camera(true_.robot_from_camera,
                                                        later_s + kSubsampleTime[k] * site_.disturbances.exposure_s);
    }
    row.site_from_camera_mid = moment.site_from_camera(true_.robot_from_camera, later_s);
    return row;
  }

  Site site_;
  Sensor sensor_;
  CameraModel true_;
  double gloss_;
  Camera camera_;
};

}  // namespace

std::unique_ptr<SimulatedCamera> make_floor_camera(const Site& site, const CameraOwner& owner,
                                                   std::shared_ptr<const FloorSource> floor, Random light) {
  return std::make_unique<SimulatedFloorCamera>(site, owner, std::move(floor), light);
}

}  // namespace weft::agents::sim
