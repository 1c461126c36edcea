#pragma once
#include <memory>

#include "agents/bodies/sim/hall/exposure_control.hpp"
#include "agents/bodies/sim/hall/hall_camera.hpp"
#include "agents/bodies/sim/simulated_camera.hpp"

namespace weft::agents::sim {

/// Takes the images of one true camera in a hall, whose shutter may roll; who exposes it is another's business.
class HallEye {
 public:
  HallEye(const Site& site, const CameraModel& actual, const HallCameraOptions& options,
          std::shared_ptr<const Hall> hall, Random light);

  /// Begins another run: each lamp is as bright as `random` makes it.
  void light_up(Random random) { camera_.set_light(HallLight(site_, random)); }
  HallImage take(const Moment& moment, const ExposureControl& exposure, std::uint64_t noise_seed);
  /// Wraps what was taken, which is left empty.
  Image image_of(HallImage& taken) const;

 private:
  std::array<Pose3, kHallSamples> poses_at(const Moment& moment, const ExposureControl& exposure,
                                           double later_s) const;

  Site site_;
  CameraModel true_;
  HallCamera camera_;
};

}  // namespace weft::agents::sim
