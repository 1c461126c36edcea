#pragma once
#include <optional>
#include <vector>

#include "tests/bench/floor/views.hpp"

namespace weft::bench {

/// What plain OpenCV makes of a camera over a floor: FAST, pyramidal KLT, a homography by USAC and its decomposition.
class PlainOdometry {
 public:
  /// How far the camera of views() went along the floor since the image before; none of the first one.
  std::optional<double> length_m(const cv::Mat& image);

 private:
  cv::Mat last_;
  std::vector<cv::Mat> last_pyramid_;
};

}  // namespace weft::bench
