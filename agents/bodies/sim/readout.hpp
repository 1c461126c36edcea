#pragma once

namespace weft::agents::sim {

/// Returns when a row of an image is taken by a rolling shutter that reads its rows in `readout_s` from the first to
/// the last, seconds from the middle one's time, which is the image's.
inline double row_time_s(double row, int rows, double readout_s) {
  return rows > 1 ? readout_s * (row / (rows - 1) - 0.5) : 0.0;
}

}  // namespace weft::agents::sim
