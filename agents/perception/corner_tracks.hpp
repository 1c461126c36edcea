#pragma once
#include <Eigen/Core>
#include <memory>
#include <utility>
#include <vector>

#include "agents/perception/view.hpp"

namespace weft::agents {

/// Returns whether the image holds width * height pixels.
bool is_whole(const Image& image);

/// Holds an image prepared for tracking. Keeps its own pixels; copies share its levels, so copying is cheap.
class TrackingImage {
 public:
  struct Levels;  ///< agents/perception/tracking_levels.hpp

  TrackingImage() = default;
  explicit TrackingImage(std::shared_ptr<const Levels> levels) : levels_(std::move(levels)) {}
  explicit operator bool() const { return levels_ != nullptr; }
  /// Returns the levels. The image has been prepared (is not default-constructed).
  const Levels& levels() const { return *levels_; }

 private:
  std::shared_ptr<const Levels> levels_;
};

/// Prepares an image for tracking with windows of `window_px` (odd), halved `levels` times (>= 1). The image is
/// whole.
TrackingImage prepare_tracking(const Image& image, int window_px, int levels);

enum class CornerDetector { fast, harris };

struct CornerConfig {
  CornerDetector detector = CornerDetector::fast;
  int count = 160;     ///< wanted
  int threshold = 16;  ///< grey levels of the FAST test (Rosten & Drummond 2006); halved down to `lowest`
  int lowest = 4;      ///< when the floor is pale
  int columns = 10;    ///< corners are spread over a grid, the strongest of each cell first
  int rows = 7;
  int border_px = 12;  ///< kept free
};

/// Returns corners, in pixels, the best of each grid cell in turn; each lies where its window's gradients meet.
std::vector<Eigen::Vector2d> find_corners(const TrackingImage& image, const CornerConfig& config);

/// Returns how much each pixel's motion counts when it is tracked, by direction in the image: symmetric, eigenvalues
/// in [0, 1], 1 where it is told best. A track's covariance is the inverse of the grey values' structure (Harris &
/// Stephens 1988), less what noise of `grey_noise` grey levels makes of it: along an edge a track slides. Half a
/// window around each pixel lies within the image.
std::vector<Eigen::Matrix2d> counts_at(const TrackingImage& image, const std::vector<Eigen::Vector2d>& pixels,
                                       double grey_noise);

struct Track {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  double error = 0.0;  ///< mean grey level difference of the windows
  bool found = false;
};

/// Finds the pixels of one image in the next by pyramidal Lucas-Kanade (Bouguet 2001), starting at `expected`; both
/// images are prepared alike.
std::vector<Track> track_corners(const TrackingImage& from, const TrackingImage& to,
                                 const std::vector<Eigen::Vector2d>& pixels,
                                 const std::vector<Eigen::Vector2d>& expected);

}  // namespace weft::agents
