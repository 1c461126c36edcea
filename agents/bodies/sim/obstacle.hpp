#pragma once
#include <cstdint>
#include <limits>
#include <string>

#include "core/geometry/pose2.hpp"

namespace weft::agents::sim {

/// Describes what stands in robots' way for a while and was not there when they were taught.
struct Obstacle {
  enum class Kind : std::uint8_t { crate, person, pallet_jack };
  Kind kind = Kind::crate;
  std::string name = "obstacle";
  Pose2 site_from_obstacle;  ///< its middle, its length along the heading
  double length_m = 0.6, width_m = 0.6, height_m = 0.6;
  std::uint64_t from_day = 0;  ///< bodies on earlier days neither see nor meet it
  double from_s = 0.0;         ///< of a body's time, as is the next
  double to_s = std::numeric_limits<double>::infinity();

  bool stands_at(double time_s) const { return time_s >= from_s && time_s < to_s; }
};

}  // namespace weft::agents::sim
