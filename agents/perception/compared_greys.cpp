#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "agents/perception/describe_upright.hpp"
#include "core/random.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kComparisons = 256;

struct Pair {
  cv::Point2d first, second;  ///< in halves of what a descriptor sees, (-1, 1)
};

/// Draws both points of each pair about the middle (G II of the paper, a little wider); the same for ever, as maps
/// hold what they gave.
std::array<Pair, kComparisons> drawn_pairs() {
  constexpr double sigma = 0.42;
  Random random(7);
  const auto drawn = [&] { return std::clamp(sigma * random.normal(), -0.98, 0.98); };
  std::array<Pair, kComparisons> pairs;
  for (Pair& pair : pairs) {
    for (double* const value : {&pair.first.x, &pair.first.y, &pair.second.x, &pair.second.y}) *value = drawn();
  }
  return pairs;
}

}  // namespace

std::vector<Descriptor> compared_greys(const cv::Mat& grey, const std::vector<cv::Point>& at,
                                       const UprightCells& cells) {
  static const std::array<Pair, kComparisons> pairs = drawn_pairs();
  cv::Mat smooth;
  cv::GaussianBlur(grey, smooth, {}, cells.smoothing_px());
  const double half = 0.5 * kUprightCells * cells.side_px;
  const auto offset = [&](const cv::Point2d& p) {
    return static_cast<std::ptrdiff_t>(std::lround(half * p.y)) * static_cast<std::ptrdiff_t>(smooth.step[0]) +
           static_cast<std::ptrdiff_t>(std::lround(half * p.x));
  };
  std::array<std::array<std::ptrdiff_t, 2>, kComparisons> offsets{};
  for (std::size_t i = 0; i < kComparisons; ++i) offsets[i] = {offset(pairs[i].first), offset(pairs[i].second)};
  std::vector<Descriptor> descriptors(at.size());
  for (std::size_t k = 0; k < at.size(); ++k) {
    const std::uint8_t* const middle = smooth.ptr(at[k].y) + at[k].x;
    for (std::size_t i = 0; i < kComparisons; ++i) {
      const std::uint64_t less = middle[offsets[i][0]] < middle[offsets[i][1]] ? 1U : 0U;
      descriptors[k][i / 64] |= less << (i % 64);
    }
  }
  return descriptors;
}

}  // namespace weft::agents
