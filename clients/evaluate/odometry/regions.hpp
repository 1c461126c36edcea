#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "clients/evaluate/odometry/row.hpp"

namespace weft::evaluate::odometry {

/// Tells how often the stated region of 95 % holds the truth, the mean over robots: a robot is a seed, with one draw
/// of a calibration's errors, and all that it drives is right or wrong by that together.
struct Region {
  std::string observer;  ///< with the camera as calibrated, or as given
  double metres = 0.0;   ///< length of the stretches
  std::size_t robots = 0;
  double held_percent = 0.0;  ///< NaN: no stretch
  /// Returns whether it is promised: of 40 robots or more.
  bool is_judged() const { return robots >= 40; }
  bool holds() const { return held_percent >= 90.0 && held_percent <= 98.0; }
};

/// Returns the regions of the product while mapping at the site's frame rate.
std::vector<Region> regions_of(const std::vector<Row>& rows);

/// Returns a line a region: what holds, of how many robots, and what was asked.
std::string words_of(const std::vector<Region>& regions);

/// Tells whether one that is judged does not hold.
bool is_any_missed(const std::vector<Region>& regions);

}  // namespace weft::evaluate::odometry
