#include "agents/perception/corner_tracks.hpp"

#include <algorithm>
#include <opencv2/features2d.hpp>
#include <opencv2/video/tracking.hpp>

#include "agents/perception/opencv_view.hpp"
#include "agents/perception/tracking_levels.hpp"

namespace weft::agents {

bool is_whole(const Image& image) {
  return image.width > 0 && image.height > 0 && image.pixels != nullptr &&
         image.pixels->size() == static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

TrackingImage prepare_tracking(const Image& image, int window_px, int levels) {
  const auto prepared = std::make_shared<TrackingImage::Levels>();
  prepared->window_px = window_px;
  prepared->image = as_mat(image);
  prepared->top = cv::buildOpticalFlowPyramid(prepared->image, prepared->pyramid, {window_px, window_px}, levels);
  // The pyramid holds copies, with borders; the first level serves for corners, so the view may go.
  prepared->image = prepared->pyramid.front();
  return TrackingImage(prepared);
}

std::vector<Eigen::Vector2d> find_corners(const TrackingImage& image, const CornerConfig& config) {
  const cv::Mat& grey = image.levels().image;
  std::vector<cv::KeyPoint> found;
  for (int threshold = config.threshold;; threshold = std::max(threshold / 2, config.lowest)) {
    cv::FAST(grey, found, threshold, true);
    if (threshold <= config.lowest || found.size() >= static_cast<std::size_t>(3 * config.count)) break;
  }
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
  return corners;
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
