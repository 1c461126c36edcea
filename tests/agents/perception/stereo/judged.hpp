#pragma once
// Judges a disparity map.
#include <cmath>
#include <cstddef>
#include <vector>

#include "agents/perception/stereo/disparity.hpp"

namespace weft::test {

/// Compares a map with true depths, where these are within what was searched: in the columns from `disparities` on,
/// where OpenCV tells anything, and not nearer.
struct Judged {
  double density = 0.0;
  double off_1px = 0.0, off_2px = 0.0;  ///< shares of what is told
  double mean_px = 0.0;                 ///< of what is told
};
inline Judged judged(const agents::DisparityMap& map, const agents::StereoRig& rig,
                     const std::vector<double>& depth_m, int disparities) {
  Judged found;
  std::size_t all = 0;
  std::size_t told = 0;
  for (int row = 0; row < map.height; ++row)
    for (int column = disparities; column < map.width; ++column) {
      const double truth = rig.disparity_px(depth_m[static_cast<std::size_t>(row * map.width + column)]);
      if (truth > disparities - 2) continue;
      ++all;
      const auto disparity = map.at(column, row);
      if (!disparity) continue;
      ++told;
      const double off = std::abs(*disparity - truth);
      found.mean_px += off;
      found.off_1px += off > 1.0 ? 1.0 : 0.0;
      found.off_2px += off > 2.0 ? 1.0 : 0.0;
    }
  found.density = static_cast<double>(told) / static_cast<double>(all);
  for (double* sum : {&found.off_1px, &found.off_2px, &found.mean_px}) *sum /= static_cast<double>(told);
  return found;
}

}  // namespace weft::test
