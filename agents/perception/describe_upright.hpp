#pragma once
// Private to the rooms that compute with OpenCV; never included by a public header.
#include <algorithm>
#include <opencv2/core.hpp>
#include <vector>

#include "agents/perception/upright_features.hpp"

namespace weft::agents {

inline constexpr int kUprightCells = 4;  ///< across what a descriptor sees, and down

struct UprightCells {
  int side_px = 12;
  double smoothing = 0.1;  ///< standard deviation, in sides
  double smoothing_px() const { return std::max(0.5, smoothing * side_px); }
};

/// Return a descriptor of each point of `at`, all of them kUprightCells / 2 cells or more from the image's rim.
std::vector<Descriptor> compared_greys(const cv::Mat& grey, const std::vector<cv::Point>& at,
                                       const UprightCells& cells);
std::vector<Descriptor> gradient_bits(const cv::Mat& grey, const std::vector<cv::Point>& at,
                                      const UprightCells& cells);

}  // namespace weft::agents
