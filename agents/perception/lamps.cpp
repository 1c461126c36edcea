#include "agents/perception/lamps.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "agents/perception/opencv_view.hpp"

namespace weft::agents {
namespace {

cv::Mat square_of(int half_px) {
  return cv::Mat::ones(2 * half_px + 1, 2 * half_px + 1, CV_8U);
}

}  // namespace

Lamps::Lamps(const Image& image, const LampConfig& config) : width_(image.width), height_(image.height) {
  const cv::Mat grey = as_mat(image);
  const cv::Mat white = grey >= config.white_grey;
  cv::Mat inner;
  cv::Mat rim;
  cv::Mat bloom;
  // The border is taken to go on beyond the image: a lamp that is cut off has no rim there.
  cv::erode(white, inner, square_of(config.rim_px));
  cv::dilate(white, rim, square_of(config.rim_px));
  cv::dilate(white, bloom, square_of(config.bloom_px));
  parts_.assign(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_), Part::beside);
  std::size_t at = 0;
  for (int row = 0; row < height_; ++row) {
    const auto* const i = inner.ptr<std::uint8_t>(row);
    const auto* const r = rim.ptr<std::uint8_t>(row);
    const auto* const b = bloom.ptr<std::uint8_t>(row);
    for (int column = 0; column < width_; ++column, ++at) {
      if (b[column] == 0) continue;
      if (i[column] != 0) {
        parts_[at] = Part::inside;
      } else {
        parts_[at] = r[column] != 0 ? Part::rim : Part::bloom;
      }
    }
  }
}

bool Lamps::counts(const Eigen::Vector2d& pixel) const {
  const auto column = static_cast<int>(std::lround(pixel.x()));
  const auto row = static_cast<int>(std::lround(pixel.y()));
  if (column < 0 || row < 0 || column >= width_ || row >= height_) return false;
  const Part part =
      parts_[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(column)];
  return part == Part::beside || part == Part::rim;
}

double grey_beside_lamps(const Image& image, const LampConfig& config) {
  constexpr double white = 255.0;
  const cv::Mat grey = as_mat(image);
  cv::Mat beside = grey < config.white_grey;
  cv::erode(beside, beside, square_of(config.bloom_px));
  return cv::countNonZero(beside) > 0 ? cv::mean(grey, beside)[0] : white;
}

}  // namespace weft::agents
