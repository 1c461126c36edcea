#include "agents/perception/stereo/stereo_corners.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "agents/perception/tracking_levels.hpp"

namespace weft::agents {
namespace {

constexpr int kCoarse = 2;  // level that is searched, at a quarter of the size
constexpr int kHalf = 3;    // of the windows that are compared there

/// Returns the mean absolute difference of the windows around two pixels of a level; infinite where one leaves its
/// image.
double difference(const cv::Mat& left, const cv::Point& at_left, const cv::Mat& right, const cv::Point& at_right) {
  const auto fits = [](const cv::Mat& image, const cv::Point& at) {
    return at.x >= kHalf && at.y >= kHalf && at.x + kHalf < image.cols && at.y + kHalf < image.rows;
  };
  if (!fits(left, at_left) || !fits(right, at_right)) return std::numeric_limits<double>::infinity();
  int sum = 0;
  for (int y = -kHalf; y <= kHalf; ++y) {
    const std::uint8_t* const one = left.ptr<std::uint8_t>(at_left.y + y) + at_left.x;
    const std::uint8_t* const other = right.ptr<std::uint8_t>(at_right.y + y) + at_right.x;
    for (int x = -kHalf; x <= kHalf; ++x) sum += std::abs(one[x] - other[x]);
  }
  return sum / double{(2 * kHalf + 1) * (2 * kHalf + 1)};
}

/// Returns where along its row a corner looks most alike in the right image, to a few pixels.
Eigen::Vector2d coarse_match(const Rectifier& rectifier, const TrackingImage::Levels& left,
                             const TrackingImage::Levels& right, const Eigen::Vector2d& corner,
                             const Eigen::Vector2d& rectified, double most_px) {
  const int level = std::min({kCoarse, left.top, right.top});
  const int scale = 1 << level;
  const cv::Mat& from = left.level(level);
  const cv::Mat& to = right.level(level);
  const auto pixel_of = [scale](const Eigen::Vector2d& pixel) {
    return cv::Point(static_cast<int>(std::lround(pixel.x() / scale)),
                     static_cast<int>(std::lround(pixel.y() / scale)));
  };
  Eigen::Vector2d best = rectifier.taken_right(rectified);
  double least = std::numeric_limits<double>::infinity();
  for (double disparity = 0.0; disparity <= most_px; disparity += scale) {
    const Eigen::Vector2d candidate = rectifier.taken_right(rectified - Eigen::Vector2d(disparity, 0.0));
    const double differs = difference(from, pixel_of(corner), to, pixel_of(candidate));
    if (differs >= least) continue;
    least = differs;
    best = candidate;
  }
  return best;
}

}  // namespace

std::vector<StereoCorner> in_both(const Rectifier& rectifier, const TrackingImage& left, const TrackingImage& right,
                                  const std::vector<Eigen::Vector2d>& corners, const StereoCornerBounds& bounds) {
  std::vector<Eigen::Vector2d> rectified;
  std::vector<Eigen::Vector2d> expected;
  for (const Eigen::Vector2d& corner : corners) {
    rectified.push_back(rectifier.rectified_left(corner));
    expected.push_back(
        coarse_match(rectifier, left.levels(), right.levels(), corner, rectified.back(), bounds.most_px));
  }
  const std::vector<Track> tracks = track_corners(left, right, corners, expected);
  std::vector<StereoCorner> found;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!tracks[i].found || tracks[i].error > bounds.most_error_grey) continue;
    const Eigen::Vector2d at_right = rectifier.rectified_right(tracks[i].pixel);
    const double disparity = rectified[i].x() - at_right.x();
    if (std::abs(rectified[i].y() - at_right.y()) > bounds.row_px || disparity < bounds.least_px ||
        disparity > bounds.most_px)
      continue;
    // Both rows are measured, and are the same one.
    const double row = 0.5 * (rectified[i].y() + at_right.y());
    found.push_back({corners[i], rectifier.rig().point_of(rectified[i].x(), row, disparity), disparity});
  }
  return found;
}

}  // namespace weft::agents
