#pragma once
#include <cstdint>
#include <vector>

#include "core/geometry/pose2.hpp"

namespace weft::agents {

/// Describes what one bearing of a scan has shown.
struct Beam {
  /// Tells where `range_m` comes from.
  enum class Return : std::uint8_t {
    none,       ///< nothing was seen to end the ray
    obstacle,   ///< something that stands in the slice
    floor_edge  ///< floor that is seen up to there and then not: weak evidence of a plain wall
  };
  double bearing_rad = 0.0;  ///< in the scan's frame, left positive
  double range_m = 0.0;      ///< without meaning where nothing returned
  double sigma_m = 0.0;      ///< of the range
  double clear_m = 0.0;      ///< up to here the ray was seen to be free
  Return kind = Return::none;
};

/// Holds ranges to what stands around a sensor at the height of a robot's body, seen from above.
struct Scan {
  Pose2 robot_from_scan;
  std::vector<Beam> beams;
  double clear_from_m = 0.0;  ///< nearer than this a low thing is out of view: no ray tells that nothing stands there
};

}  // namespace weft::agents
