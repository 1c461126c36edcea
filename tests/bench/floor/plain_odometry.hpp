#pragma once
#include <optional>
#include <vector>

#include "tests/bench/floor/views.hpp"

namespace weft::bench {

/// Sees a camera's motion over a floor by plain OpenCV: FAST, pyramidal KLT, a homography by USAC, its decomposition.
class PlainOdometry {
 public:
  /// Returns how far the camera of views() went along the floor since the image before; none of the first one.
  std::optional<double> length_m(const cv::Mat& image);

 private:
  cv::Mat last_;
  std::vector<cv::Mat> last_pyramid_;
};

}  // namespace weft::bench
