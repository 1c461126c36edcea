#pragma once
#include <string>

namespace weft::evaluate::floor {

/// Returns a site file: a hall without racks whose robot starts at x = 2 and `y`, metres, with a small camera, which
/// is quick.
inline std::string small_hall(double x_max, double y_max, double y) {
  return "[floor]\nx_min = 0.0\ny_min = 0.0\nx_max = " + std::to_string(x_max) +
         "\ny_max = " + std::to_string(y_max) +
         "\n[camera]\nwidth_px = 376\nheight_px = 240\nfocal_px = 230\n[[robot]]\nname = \"r1\"\nx = 2.0\ny = " +
         std::to_string(y) + "\n";
}

}  // namespace weft::evaluate::floor
