#include "agents/perception/scaled_descriptors.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>

#include "agents/perception/describe_upright.hpp"
#include "agents/perception/opencv_view.hpp"

namespace weft::agents {
namespace {

/// Describes a size of cells: pixels of the image halved so many times.
struct ScaleRung {
  int side_px;
  int halvings;
  double taken_px() const { return side_px * std::exp2(halvings); }
};
constexpr std::array<ScaleRung, 8> kScaleRungs = {{{3, 0}, {4, 0}, {5, 0}, {7, 0}, {5, 1}, {7, 1}, {4, 2}, {5, 2}}};

std::size_t rung_of(double cell_px) {
  std::size_t best = 0;
  const auto off = [&](const ScaleRung& rung) { return std::abs(std::log(cell_px / rung.taken_px())); };
  for (std::size_t i = 1; i < kScaleRungs.size(); ++i)
    if (off(kScaleRungs[i]) < off(kScaleRungs[best])) best = i;
  return best;
}

}  // namespace

std::vector<std::optional<Descriptor>> describe_at_scale(const Image& image, std::span<const ScaledPoint> points) {
  std::array<cv::Mat, 3> halved = {as_mat(image), {}, {}};
  for (std::size_t i = 1; i < halved.size(); ++i) cv::pyrDown(halved[i - 1], halved[i]);
  std::vector<std::optional<Descriptor>> descriptors(points.size());
  for (std::size_t rung = 0; rung < kScaleRungs.size(); ++rung) {
    const cv::Mat& grey = halved[static_cast<std::size_t>(kScaleRungs[rung].halvings)];
    const UprightCells cells{kScaleRungs[rung].side_px};
    const int half = kUprightCells * cells.side_px / 2;
    const cv::Rect described(half, half, grey.cols - 2 * half, grey.rows - 2 * half);
    std::vector<cv::Point> at;
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (rung_of(points[i].cell_px) != rung) continue;
      const Eigen::Vector2d pixel = points[i].pixel / std::exp2(kScaleRungs[rung].halvings);
      const cv::Point whole(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
      if (!described.contains(whole)) continue;
      at.push_back(whole);
      which.push_back(i);
    }
    const std::vector<Descriptor> found = gradient_bits(grey, at, cells);
    for (std::size_t i = 0; i < which.size(); ++i) descriptors[which[i]] = found[i];
  }
  return descriptors;
}

}  // namespace weft::agents
