#include "agents/bodies/sim/hall_eye.hpp"

#include <cmath>
#include <utility>

#include "agents/bodies/sim/readout.hpp"

namespace weft::agents::sim {
namespace {

/// Sets the times of the samples as shares of the exposure, from its middle, in order: the middles of its quarters.
constexpr std::array<double, kHallSamples> kSampleTime = {-0.375, -0.125, 0.125, 0.375};

}  // namespace

HallEye::HallEye(const Site& site, const CameraModel& actual, const HallCameraOptions& options,
                 std::shared_ptr<const Hall> hall, Random light)
    : site_(site),
      true_(actual),
      camera_(true_, options, std::move(hall), {site.movers, site.obstacles}, HallLight(site, light)) {}

/// Returns where the camera is for rows that are taken so much later than the image's middle.
std::array<Pose3, kHallSamples> HallEye::poses_at(const Moment& moment, const ExposureControl& exposure,
                                                  double later_s) const {
  std::array<Pose3, kHallSamples> poses;
  for (std::size_t k = 0; k < kHallSamples; ++k)
    poses[k] = moment.site_from_camera(true_.robot_from_camera, later_s + kSampleTime[k] * exposure.exposure_s());
  return poses;
}

HallImage HallEye::take(const Moment& moment, const ExposureControl& exposure, std::uint64_t noise_seed) {
  HallShot shot;
  shot.site_from_camera = poses_at(moment, exposure, 0.0);
  if (const double readout_s = site_.disturbances.rolling_shutter_s; readout_s > 0.0) {
    for (int band = 0; band < true_.height / kHallBand; ++band) {
      const double middle_row = kHallBand * band + (kHallBand - 1) / 2.0;
      shot.bands.push_back(poses_at(moment, exposure, row_time_s(middle_row, true_.height, readout_s)));
    }
  }
  shot.time_s = moment.time_s;
  shot.waited_s = moment.waited_s;
  shot.gain = exposure.gain() * moment.brightness;
  shot.noise_grey = site_.disturbances.noise_grey * std::sqrt(exposure.amplified());
  shot.noise_seed = noise_seed;
  return camera_.take(shot);
}

Image HallEye::image_of(HallImage& taken) const {
  return {true_.width, true_.height, std::make_shared<const Bytes>(std::move(taken.grey))};
}

}  // namespace weft::agents::sim
