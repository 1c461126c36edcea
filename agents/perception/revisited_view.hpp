#pragma once
#include <cstdint>
#include <optional>

#include "agents/perception/attitude.hpp"
#include "agents/perception/camera_model.hpp"
#include "agents/perception/floor_wear.hpp"
#include "agents/perception/view.hpp"

namespace weft::agents {

/// Describes another look at the floor, by how it differs from an image that there is.
struct OtherLook {
  Pose2 robot_from_other;         ///< where the other robot stands
  Attitude attitude;              ///< of its camera against its calibration
  double light = 1.0;             ///< factor on the grey levels; (0, 1]
  std::optional<FloorWear> wear;  ///< what lies on the floor by then
  std::uint64_t seed = 0;         ///< of noise and wear
};

/// Returns one sigma of the sensor's noise, grey levels: Immerkaer 1996 ("Fast noise variance estimation"), eq. 4,
/// where the image is smoothest; what texture there is counts as noise. The image is whole.
double noise_of(const Image& image);

/// Returns the image in so much less light (a factor on the grey levels; (0, 1]), with as much noise as it has. The
/// image is whole. Pure.
Image darker(const Image& image, double light, std::uint64_t seed);

/// Returns the image that a camera of that calibration would have taken: the floor warped as a plane, worn, in that
/// light, with as much noise as the image has. Floor beyond the image's rim is filled by mirroring the image there:
/// it is other floor, but not blank. The image is whole and of the camera's size. Pure.
Image revisited_view(const Image& image, const CameraModel& camera, const OtherLook& look);

}  // namespace weft::agents
