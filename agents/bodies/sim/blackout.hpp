#pragma once
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace weft::agents::sim {

/// Describes when, or where, the cameras of a robot see nothing of the site, or not what is there.
struct Blackout {
  enum class Kind : std::uint8_t {
    dark,          ///< hardly any light is left
    covered,       ///< something is right before every lens
    left_covered,  ///< something is right before the left lens of a pair
    frozen         ///< the image before comes again and again
  };
  /// Describes a circle on the floor, site frame.
  struct Circle {
    double x = 0.0, y = 0.0;
    double radius_m = 1.0;
  };
  Kind kind = Kind::dark;
  double from_s = 0.0;  ///< of a body's time, as is the next
  double to_s = std::numeric_limits<double>::infinity();
  std::optional<Circle> near = {};  ///< while the robot's middle is in there; none: wherever it is

  /// Returns whether a robot at (x, y) has it at that time.
  bool holds(double time_s, double x, double y) const {
    const bool is_there = !near || std::hypot(x - near->x, y - near->y) <= near->radius_m;
    return is_there && time_s >= from_s && time_s < to_s;
  }
};

}  // namespace weft::agents::sim
