#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "agents/perception/describe_upright.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kDirections = 8;
constexpr std::size_t kCells = static_cast<std::size_t>(kUprightCells) * kUprightCells;
using Strengths = std::array<std::array<float, kDirections>, kCells>;

/// Sums of the gradient's strength in each direction over all pixels above and to the left: its component there,
/// narrowed by the cosine to the fourth.
std::array<cv::Mat, kDirections> summed_gradients(const cv::Mat& grey, double smoothing_px) {
  cv::Mat smooth;
  grey.convertTo(smooth, CV_32F);
  cv::GaussianBlur(smooth, smooth, {}, smoothing_px);
  cv::Mat right;
  cv::Mat down;
  cv::Sobel(smooth, right, CV_32F, 1, 0);
  cv::Sobel(smooth, down, CV_32F, 0, 1);
  std::array<cv::Mat, kDirections> sums;
  cv::Mat strength(grey.size(), CV_32F);
  for (std::size_t d = 0; d < kDirections; ++d) {
    const double angle = 2.0 * M_PI * static_cast<double>(d) / kDirections;
    const auto c = static_cast<float>(std::cos(angle));
    const auto s = static_cast<float>(std::sin(angle));
    for (int row = 0; row < grey.rows; ++row) {
      const auto* const x = right.ptr<float>(row);
      const auto* const y = down.ptr<float>(row);
      auto* const out = strength.ptr<float>(row);
      for (int i = 0; i < grey.cols; ++i) {
        const float along = std::max(0.0F, c * x[i] + s * y[i]);
        const float share = along * along / (x[i] * x[i] + y[i] * y[i] + 1e-3F);  // cosine squared
        out[i] = along * share * share;
      }
    }
    cv::integral(strength, sums[d], CV_64F);
  }
  return sums;
}

Strengths strengths_at(const std::array<cv::Mat, kDirections>& sums, const cv::Point& at, int cell_px) {
  Strengths strengths{};
  const int half = kUprightCells * cell_px / 2;
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    const int left = at.x - half + static_cast<int>(cell % kUprightCells) * cell_px;
    const int top = at.y - half + static_cast<int>(cell / kUprightCells) * cell_px;
    for (std::size_t d = 0; d < kDirections; ++d) {
      const auto* const above = sums[d].ptr<double>(top);
      const auto* const below = sums[d].ptr<double>(top + cell_px);
      strengths[cell][d] =
          static_cast<float>(below[left + cell_px] - below[left] - above[left + cell_px] + above[left]);
    }
  }
  return strengths;
}

Descriptor bits_of(const Strengths& strengths) {
  std::array<float, kDirections> of_direction{};
  Descriptor bits{};
  std::size_t next = 0;
  const auto append = [&](bool bit) {
    bits[next / 64] |= static_cast<std::uint64_t>(bit) << (next % 64);
    ++next;
  };
  for (const auto& cell : strengths) {
    float mean = 0.0F;
    for (std::size_t d = 0; d < kDirections; ++d) {
      mean += cell[d] / kDirections;
      of_direction[d] += cell[d] / kCells;
    }
    for (const float strength : cell) append(strength > mean);
  }
  for (const auto& cell : strengths)
    for (std::size_t d = 0; d < kDirections; ++d) append(cell[d] > of_direction[d]);
  return bits;
}

}  // namespace

std::vector<Descriptor> gradient_bits(const cv::Mat& grey, const std::vector<cv::Point>& at,
                                      const UprightCells& cells) {
  std::vector<Descriptor> descriptors;
  if (at.empty()) return descriptors;
  const std::array<cv::Mat, kDirections> sums = summed_gradients(grey, cells.smoothing_px());
  for (const cv::Point& p : at) descriptors.push_back(bits_of(strengths_at(sums, p, cells.side_px)));
  return descriptors;
}

}  // namespace weft::agents
