#include "agents/perception/harris.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>

namespace weft::agents {

cv::Mat harris_response(const cv::Mat& grey, const HarrisConfig& config) {
  cv::Mat dx;
  cv::Mat dy;
  // Scharr's weights, so that a corner counts alike whichever way it is turned.
  constexpr double per_pixel = 1.0 / 32.0;
  cv::Scharr(grey, dx, CV_32F, 1, 0, per_pixel);
  cv::Scharr(grey, dy, CV_32F, 0, 1, per_pixel);
  const auto windowed = [&config](const cv::Mat& product) {
    cv::Mat out;
    cv::GaussianBlur(product, out, {}, config.window_px);
    return out;
  };
  const cv::Mat a = windowed(dx.mul(dx));
  const cv::Mat b = windowed(dy.mul(dy));
  const cv::Mat c = windowed(dx.mul(dy));
  const cv::Mat trace = a + b;
  return a.mul(b) - c.mul(c) - trace.mul(trace, config.sensitivity);
}

std::vector<cv::KeyPoint> harris_corners(const cv::Mat& grey, const HarrisConfig& config) {
  const cv::Mat response = harris_response(grey, config);
  cv::Mat largest;  // of each pixel's neighbourhood
  cv::dilate(response, largest, {});
  double strongest = 0.0;
  cv::minMaxLoc(response, nullptr, &strongest);
  const auto least = static_cast<float>(config.least_share * strongest);
  constexpr float size_px = 7.0F;
  std::vector<cv::KeyPoint> corners;
  for (int row = 1; row + 1 < response.rows; ++row) {
    const auto* const here = response.ptr<float>(row);
    const auto* const around = largest.ptr<float>(row);
    for (int column = 1; column + 1 < response.cols; ++column) {
      if (here[column] < around[column] || here[column] <= 0.0F || here[column] < least) continue;
      corners.emplace_back(static_cast<float>(column), static_cast<float>(row), size_px, -1.0F, here[column]);
    }
  }
  return corners;
}

}  // namespace weft::agents
