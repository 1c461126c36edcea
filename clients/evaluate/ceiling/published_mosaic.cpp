#include "clients/evaluate/ceiling/published_mosaic.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <vector>

#include "agents/perception/homography.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/plane/geometry.hpp"

namespace weft::evaluate::ceiling {
namespace {

using namespace agents;

constexpr int kMosaicWindowPx = 13;
constexpr int kMosaicLevels = 3;
constexpr double kMosaicInlierPx = 2.0;

/// Returns the homography that takes an image to the one before, normalised coordinates. None: it is not found.
std::optional<Eigen::Matrix3d> previous_from_current(const CameraModel& camera, const TrackingImage& previous,
                                                     const TrackingImage& current) {
  CornerConfig corners;
  corners.detector = CornerDetector::harris;
  corners.count = 200;
  corners.border_px = kMosaicWindowPx / 2 + 3;
  const std::vector<Eigen::Vector2d> from = find_corners(previous, corners);
  const std::vector<Track> to = track_corners(previous, current, from, from);
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < to.size(); ++i)
    if (to[i].found) order.push_back(i);
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t x, std::size_t y) { return to[x].error < to[y].error; });
  std::vector<Eigen::Vector2d> in_current;
  std::vector<Eigen::Vector2d> in_previous;
  for (const std::size_t i : order) {
    in_current.push_back(normalised_from_pixel(camera, to[i].pixel));
    in_previous.push_back(normalised_from_pixel(camera, from[i]));
  }
  const auto found = robust_homography(in_current, in_previous, kMosaicInlierPx / focal_px(camera));
  return found ? std::optional(found->b_from_a) : std::nullopt;
}

}  // namespace

void PublishedMosaic::add(const Image& image) {
  const TrackingImage current = prepare_tracking(image, kMosaicWindowPx, kMosaicLevels);
  if (!newest_) {
    first_centroid_ = centroid();
  } else if (const auto step = previous_from_current(camera_, newest_, current)) {
    mosaic_from_image_ = mosaic_from_image_ * *step;
    mosaic_from_image_ /= mosaic_from_image_(2, 2);
  } else {
    ++not_joined_;
  }
  newest_ = current;
}

Eigen::Vector2d PublishedMosaic::centroid() const {
  const double right = camera_.width - 1.0;
  const double bottom = camera_.height - 1.0;
  const std::array<Eigen::Vector2d, 4> corners = {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(right, 0.0),
                                                  Eigen::Vector2d(right, bottom), Eigen::Vector2d(0.0, bottom)};
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : corners)
    sum += agents::apply(mosaic_from_image_, normalised_from_pixel(camera_, corner));
  return 0.25 * sum;
}

Eigen::Vector2d PublishedMosaic::robot_in_start() const {
  if (!newest_) return Eigen::Vector2d::Zero();
  const Eigen::Matrix3d robot_from_camera = camera_.robot_from_camera.rotation.toRotationMatrix();
  return robot_from_camera.topLeftCorner<2, 2>() * (centroid() - first_centroid_);
}

}  // namespace weft::evaluate::ceiling
