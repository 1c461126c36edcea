#include "agents/perception/corner_tracks.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/features2d.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "agents/perception/harris.hpp"
#include "agents/perception/opencv_view.hpp"
#include "agents/perception/tracking_levels.hpp"
#include "agents/perception/tracking_target.hpp"

namespace weft::agents {

bool is_whole(const Image& image) {
  return image.width > 0 && image.height > 0 && image.pixels != nullptr &&
         image.pixels->size() == static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

namespace {

/// Returns grey values less the mean of their surroundings. Vignetting, exposure, lamps and soft shadows make a
/// window brighter or darker as it moves through the image, which a tracker takes for motion where the floor's grey
/// values rise or fall: a third to a half of the error of speed (docs/decisions/024-odometry-candidates.md).
cv::Mat flattened(const cv::Mat& grey, int window_px) {
  constexpr double middle = 128.0;
  const int around = (window_px / 4) * 2 + 1;  // in a quarter of the image: twice the window, at a third of the time
  cv::Mat half;
  cv::Mat mean;
  const auto halved = [](const cv::Mat& of) { return cv::Size((of.cols + 1) / 2, (of.rows + 1) / 2); };
  cv::resize(grey, half, halved(grey), 0.0, 0.0, cv::INTER_AREA);
  cv::resize(half, mean, halved(half), 0.0, 0.0, cv::INTER_AREA);
  cv::boxFilter(mean, mean, -1, {around, around});
  cv::resize(mean, mean, grey.size(), 0.0, 0.0, cv::INTER_LINEAR);
  cv::Mat flat;
  cv::addWeighted(grey, 1.0, mean, -1.0, middle, flat);
  return flat;
}

/// Returns how much windows that move by a little differ, by direction: the mean over the tracker's window of the
/// grey values' gradient times its transpose, (grey levels a pixel)^2 (Harris & Stephens 1988).
Eigen::Matrix2d structure_at(const TrackingImage& image, const Eigen::Vector2d& pixel) {
  constexpr double per_pixel = 1.0 / 32.0;  // Scharr's weights
  const cv::Mat& gradient = image.levels().pyramid[1];
  const int half = image.levels().window_px / 2;
  const int column = static_cast<int>(std::lround(pixel.x()));
  const int row = static_cast<int>(std::lround(pixel.y()));
  std::int64_t xx = 0;
  std::int64_t xy = 0;
  std::int64_t yy = 0;
  for (int r = row - half; r <= row + half; ++r) {
    const auto* const line = gradient.ptr<cv::Vec2s>(r);
    for (int c = column - half; c <= column + half; ++c) {
      xx += line[c][0] * line[c][0];
      xy += line[c][0] * line[c][1];
      yy += line[c][1] * line[c][1];
    }
  }
  Eigen::Matrix2d sum;
  sum << static_cast<double>(xx), static_cast<double>(xy), static_cast<double>(xy), static_cast<double>(yy);
  const double pixels = (2.0 * half + 1.0) * (2.0 * half + 1.0);
  return sum * per_pixel * per_pixel / pixels;
}

TrackingImage with_levels(const cv::Mat& flat, int window_px, int levels, bool has_gradients) {
  const auto prepared = std::make_shared<TrackingImage::Levels>();
  prepared->window_px = window_px;
  prepared->has_gradients = has_gradients;
  prepared->top = cv::buildOpticalFlowPyramid(flat, prepared->pyramid, {window_px, window_px}, levels, has_gradients);
  // The pyramid holds copies, with borders; the first level serves for corners, so the view may go.
  prepared->image = prepared->pyramid.front();
  return TrackingImage(prepared);
}

}  // namespace

TrackingImage prepare_tracking(const Image& image, int window_px, int levels) {
  return with_levels(flattened(as_mat(image), window_px), window_px, levels, true);
}

TrackingImage prepare_target(const Image& image, int window_px, int levels) {
  return with_levels(flattened(as_mat(image), window_px), window_px, levels, false);
}

TrackingImage with_gradients(const TrackingImage& image) {
  const TrackingImage::Levels& levels = image.levels();
  if (levels.has_gradients) return image;
  return with_levels(levels.image, levels.window_px, levels.top, true);
}

namespace {

/// Moves corners to where their windows' gradients meet (Foerstner & Guelch 1987). A window's motion is that of its
/// gradients, and the image grows and turns as the robot drives: measured on a joint at the window's side but taken
/// for the middle's, it bent ways on tiles by 0.1 degrees a metre.
void centre_windows(const TrackingImage& image, int border_px, std::vector<Eigen::Vector2d>& corners) {
  if (corners.empty()) return;
  std::vector<cv::Point2f> centres;
  for (const Eigen::Vector2d& corner : corners)
    centres.emplace_back(static_cast<float>(corner.x()), static_cast<float>(corner.y()));
  const int half = image.levels().window_px / 2;
  constexpr int most_steps = 5;
  constexpr double settled_px = 0.05;
  const cv::Mat& grey = image.levels().image;
  cv::cornerSubPix(grey, centres, {half, half}, {-1, -1},
                   {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, most_steps, settled_px});
  const cv::Rect2f within(static_cast<float>(border_px), static_cast<float>(border_px),
                          static_cast<float>(grey.cols - 2 * border_px),
                          static_cast<float>(grey.rows - 2 * border_px));
  for (std::size_t i = 0; i < corners.size(); ++i)
    if (within.contains(centres[i])) corners[i] = {centres[i].x, centres[i].y};
}

/// Returns FAST corners; the fewer there are, the fainter ones.
std::vector<cv::KeyPoint> fast_corners(const cv::Mat& grey, const CornerConfig& config) {
  std::vector<cv::KeyPoint> found;
  for (int threshold = config.threshold;; threshold = std::max(threshold / 2, config.lowest)) {
    cv::FAST(grey, found, threshold, true);
    if (threshold <= config.lowest || found.size() >= static_cast<std::size_t>(3 * config.count)) break;
  }
  return found;
}

}  // namespace

std::vector<Eigen::Vector2d> find_corners(const TrackingImage& image, const CornerConfig& config) {
  const cv::Mat& grey = image.levels().image;
  const std::vector<cv::KeyPoint> found =
      config.detector == CornerDetector::harris ? harris_corners(grey, {}) : fast_corners(grey, config);
  const float border = static_cast<float>(config.border_px);
  std::vector<std::vector<cv::KeyPoint>> cells(static_cast<std::size_t>(config.columns * config.rows));
  for (const cv::KeyPoint& k : found) {
    if (k.pt.x < border || k.pt.y < border || k.pt.x >= static_cast<float>(grey.cols) - border ||
        k.pt.y >= static_cast<float>(grey.rows) - border)
      continue;
    const int column = static_cast<int>(k.pt.x) * config.columns / grey.cols;
    const int row = static_cast<int>(k.pt.y) * config.rows / grey.rows;
    cells[static_cast<std::size_t>(row * config.columns + column)].push_back(k);
  }
  for (auto& cell : cells)
    std::stable_sort(cell.begin(), cell.end(),
                     [](const cv::KeyPoint& a, const cv::KeyPoint& b) { return a.response > b.response; });
  std::vector<Eigen::Vector2d> corners;
  const auto wanted = static_cast<std::size_t>(config.count);
  for (std::size_t turn = 0; corners.size() < wanted; ++turn) {
    const std::size_t before = corners.size();
    for (const auto& cell : cells)
      if (turn < cell.size() && corners.size() < wanted) corners.emplace_back(cell[turn].pt.x, cell[turn].pt.y);
    if (corners.size() == before) break;
  }
  centre_windows(image, config.border_px, corners);
  return corners;
}

std::vector<Eigen::Matrix2d> counts_at(const TrackingImage& image, const std::vector<Eigen::Vector2d>& pixels,
                                       double grey_noise) {
  constexpr double gradient_noise = 2.0 * (3.0 * 3.0 + 10.0 * 10.0 + 3.0 * 3.0) / (32.0 * 32.0);  // Scharr's, squared
  const double noise = gradient_noise * grey_noise * grey_noise;
  std::vector<Eigen::Matrix2d> counts;
  counts.reserve(pixels.size());
  for (const Eigen::Vector2d& pixel : pixels) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> parts(structure_at(image, pixel));
    const double less = std::max(parts.eigenvalues()(0) - noise, 0.0);
    const double more = parts.eigenvalues()(1) - noise;
    const double share = more > 0.0 ? std::sqrt(less / more) : 1.0;
    const Eigen::Matrix2d& axes = parts.eigenvectors();
    counts.emplace_back(axes * Eigen::Vector2d(share, 1.0).asDiagonal() * axes.transpose());
  }
  return counts;
}

std::vector<Track> track_corners(const TrackingImage& from, const TrackingImage& to,
                                 const std::vector<Eigen::Vector2d>& pixels,
                                 const std::vector<Eigen::Vector2d>& expected) {
  std::vector<Track> tracks(pixels.size());
  if (pixels.empty()) return tracks;
  std::vector<cv::Point2f> start;
  std::vector<cv::Point2f> end;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    start.emplace_back(static_cast<float>(pixels[i].x()), static_cast<float>(pixels[i].y()));
    end.emplace_back(static_cast<float>(expected[i].x()), static_cast<float>(expected[i].y()));
  }
  std::vector<std::uint8_t> status;
  std::vector<float> error;
  const int window = from.levels().window_px;
  cv::calcOpticalFlowPyrLK(from.levels().pyramid, to.levels().pyramid, start, end, status, error, {window, window},
                           std::min(from.levels().top, to.levels().top),
                           {cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 20, 0.01}, cv::OPTFLOW_USE_INITIAL_FLOW);
  const double margin = 2.0;
  const double right = to.levels().image.cols - 1.0 - margin;
  const double bottom = to.levels().image.rows - 1.0 - margin;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    tracks[i].pixel = {end[i].x, end[i].y};
    tracks[i].error = error[i];
    tracks[i].found =
        status[i] != 0 && end[i].x > margin && end[i].y > margin && end[i].x < right && end[i].y < bottom;
  }
  return tracks;
}

}  // namespace weft::agents
