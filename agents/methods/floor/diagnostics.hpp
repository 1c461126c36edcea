#pragma once
#include <string_view>

namespace weft::agents {

/// Names the diagnostic that says how much higher, in metres, a camera stands above its calibration than the camera
/// of a place stood above its own.
inline constexpr std::string_view kHeightOffset = "height_offset_m";
/// Sets the least offset, in metres, that is noticed: 1 cm of sinking is; 3 mm, as two calibrations differ, are not.
inline constexpr double kHeightNoticedM = 0.007;

}  // namespace weft::agents
