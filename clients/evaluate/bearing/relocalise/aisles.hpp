#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "agents/bodies/body.hpp"
#include "agents/bodies/sim/site.hpp"
#include "core/random.hpp"

namespace weft::evaluate::bearing {

/// Says which loads the racks of a hall's aisles hold. Their steel, their spacing and the lamps are the same in every
/// aisle.
enum class Loads : std::uint8_t {
  other,     ///< each rack its own
  one_side,  ///< what a robot has on its right is the same in every aisle
  same       ///< every aisle holds the same
};

/// Describes a hall of aisles that look alike, one beside the other along x.
struct Aisles {
  static constexpr std::size_t kCount = 4;
  agents::sim::Site site;  ///< its robot stands where the first aisle's line begins

  std::size_t left_out = 0;  ///< the aisle that nobody teaches
  std::vector<std::size_t> taught() const;
  /// Returns the line that robots are led along while it is taught: from before the racks nearly to their end.
  std::vector<agents::SitePoint> line(std::size_t aisle) const;
};

/// Makes a hall with the camera, base, hand and disturbances of `like`; the seed decides walls, floor and loads.
Aisles aisles_like(const agents::sim::Site& like, Loads loads, std::uint64_t seed);

/// Sets how far a robot is led until it is to know where it is.
inline constexpr double kLedM = 2.0;

/// Says where a robot is put down, and along what it is led.
struct PutDown {
  Pose2 site_from_robot;
  std::vector<agents::SitePoint> way;
};
/// Draws a pose on the aisle's line, a little beside it and a little askew.
PutDown on_the_line(std::size_t aisle, Random& random);
/// Draws a pose in any aisle or before or behind them, at any heading; from there a robot is led on either way.
PutDown anywhere(Random& random);

}  // namespace weft::evaluate::bearing
