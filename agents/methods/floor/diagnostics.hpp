#pragma once
#include <string_view>

namespace weft::agents {

/// By how much higher above its calibration a camera stands than the camera of a place stood above its own.
inline constexpr std::string_view kHeightOffset = "height_offset_m";
/// From here on the offset is noticed: 1 cm of sinking is, and two calibrations, which differ by 3 mm, are not.
inline constexpr double kHeightNoticedM = 0.007;

}  // namespace weft::agents
