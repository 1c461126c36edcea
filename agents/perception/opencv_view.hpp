#pragma once
// Private to the rooms that compute with OpenCV; never included by a public header.
#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "agents/perception/view.hpp"

namespace weft::agents {

/// Returns a header over the image's pixels: nothing is copied, and nothing may be written through it. The image is
/// whole (`is_whole`).
inline cv::Mat as_mat(const Image& image) {
  // OpenCV has no read-only matrix; this is its way of looking at memory that is not its own.
  return {image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.pixels->data())};
}

inline cv::Matx33d as_matx(const Eigen::Matrix3d& m) {
  return {m(0, 0), m(0, 1), m(0, 2), m(1, 0), m(1, 1), m(1, 2), m(2, 0), m(2, 1), m(2, 2)};
}

inline Eigen::Matrix3d as_eigen(const cv::Matx33d& m) {
  Eigen::Matrix3d out;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) out(r, c) = m(r, c);
  return out;
}

}  // namespace weft::agents
