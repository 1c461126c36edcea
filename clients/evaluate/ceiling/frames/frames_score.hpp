#pragma once
#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>

#include "clients/evaluate/ceiling/frames/recording.hpp"
#include "clients/evaluate/ceiling/frames/tracked.hpp"
#include "core/result.hpp"

namespace weft::evaluate::ceiling {

/// Bounds how far a relation of two frames may lie beside golden: heights of the ceiling above the camera, degrees.
inline constexpr double kWrongHeights = 0.05;
inline constexpr double kWrongDeg = 3.0;

/// Holds what a recording's odometry and relations come to, against golden.
struct FramesScore {
  std::size_t frames = 0;
  std::size_t lost = 0;                             ///< after the first, whose motion was not seen
  double rms_heights = 0.0;                         ///< of the positions, no scale fitted
  double rms_fitted_heights = 0.0;                  ///< a scale fitted
  double yaw_deg = 0.0;                             ///< RMS of the headings about their mean difference
  double tilt_deg = 0.0;                            ///< of the camera's axis, as the images show it
  std::size_t pairs = 0;                            ///< of frames that are places
  std::size_t accepted_pairs = 0;                   ///< related without a guess
  std::size_t wrong_pairs = 0;                      ///< of these, off by more than kWrongHeights or kWrongDeg
  std::map<std::string, std::size_t> refused = {};  ///< pairs, by reason
};

/// Compares the odometry alone.
FramesScore score_of(const Recording& recording, const Tracked& tracked, const agents::CameraModel& camera);

/// Measures odometry and all pairs. None: stopped. Errors of `mounted` and of the method.
Result<std::optional<FramesScore>> measure_frames(const Recording& recording,
                                                  const std::function<bool()>& asked_to_stop);

}  // namespace weft::evaluate::ceiling
