#include <array>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>

#include "agents/perception/describe_upright.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kDirections = 8;
constexpr std::size_t kCells = static_cast<std::size_t>(kUprightCells) * kUprightCells;
using Strengths = std::array<std::array<float, kDirections>, kCells>;

/// Sums over all pixels above and to the left, of all directions side by side, modulo 2^32: what lies within a cell
/// comes out right as long as that itself has room.
struct SummedGradients {
  std::size_t row_of = 0;  ///< numbers
  std::vector<std::uint32_t> sums;

  const std::uint32_t* at(int x, int y) const {
    return sums.data() + static_cast<std::size_t>(y) * row_of + static_cast<std::size_t>(x) * kDirections;
  }
};

/// Holds directions evenly round the circle.
struct Directions {
  std::array<float, kDirections> x{}, y{};
};
Directions directions() {
  Directions all;
  for (std::size_t d = 0; d < kDirections; ++d) {
    const double angle = 2.0 * M_PI * static_cast<double>(d) / kDirections;
    all.x[d] = static_cast<float>(std::cos(angle));
    all.y[d] = static_cast<float>(std::sin(angle));
  }
  return all;
}

/// Sums the gradient's strength in each direction: its component there, narrowed by the cosine to the fourth.
SummedGradients summed_gradients(const cv::Mat& grey, double smoothing_px) {
  cv::Mat smooth;
  grey.convertTo(smooth, CV_32F);
  cv::GaussianBlur(smooth, smooth, {}, smoothing_px);
  cv::Mat right;
  cv::Mat down;
  cv::Sobel(smooth, right, CV_32F, 1, 0);
  cv::Sobel(smooth, down, CV_32F, 0, 1);
  SummedGradients summed;
  summed.row_of = static_cast<std::size_t>(grey.cols + 1) * kDirections;
  summed.sums.assign(summed.row_of * static_cast<std::size_t>(grey.rows + 1), 0);
  const Directions to = directions();
  constexpr float steps = 16.0F;  // of a grey level
  for (int row = 0; row < grey.rows; ++row) {
    const auto* const x = right.ptr<float>(row);
    const auto* const y = down.ptr<float>(row);
    const std::uint32_t* above = summed.at(1, row);
    auto* out = summed.sums.data() + static_cast<std::size_t>(row + 1) * summed.row_of + kDirections;
    std::array<std::uint32_t, kDirections> in_row{};
    for (int i = 0; i < grey.cols; ++i, above += kDirections, out += kDirections) {
      const float scale = 1.0F / (x[i] * x[i] + y[i] * y[i] + 1e-3F);
      for (std::size_t d = 0; d < kDirections; ++d) {
        const float along = std::max(0.0F, to.x[d] * x[i] + to.y[d] * y[i]);
        const float share = along * along * scale;  // cosine squared
        in_row[d] += static_cast<std::uint32_t>(static_cast<std::int32_t>(steps * along * share * share));
        out[d] = above[d] + in_row[d];
      }
    }
  }
  return summed;
}

Strengths strengths_at(const SummedGradients& summed, const cv::Point& at, int cell_px) {
  Strengths strengths{};
  const int half = kUprightCells * cell_px / 2;
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    const int left = at.x - half + static_cast<int>(cell % kUprightCells) * cell_px;
    const int top = at.y - half + static_cast<int>(cell / kUprightCells) * cell_px;
    const std::uint32_t* const above = summed.at(left, top);
    const std::uint32_t* const below = summed.at(left, top + cell_px);
    const std::size_t across = static_cast<std::size_t>(cell_px) * kDirections;
    for (std::size_t d = 0; d < kDirections; ++d)
      strengths[cell][d] = static_cast<float>(below[across + d] - below[d] - above[across + d] + above[d]);
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
  const SummedGradients summed = summed_gradients(grey, cells.smoothing_px());
  for (const cv::Point& p : at) descriptors.push_back(bits_of(strengths_at(summed, p, cells.side_px)));
  return descriptors;
}

}  // namespace weft::agents
