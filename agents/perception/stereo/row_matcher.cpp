#include "agents/perception/stereo/row_matcher.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "agents/perception/opencv_view.hpp"

namespace weft::agents {

static_assert(semi_global::kAmbiguous == DisparityMap::none);

namespace {

constexpr int kRim = 2;  // pixels around an image that repeat its border

FiveRows rows_around(const cv::Mat& with_rim, int row) {
  FiveRows five;
  for (int i = 0; i < 5; ++i) five.row[i] = with_rim.ptr<std::uint8_t>(row + i) + kRim;
  return five;
}

/// Returns by the least sum up to which another is too near, as semi_global::Row has it.
std::array<std::uint8_t, 256> too_near_of(double uniqueness) {
  std::array<std::uint8_t, 256> near{};
  for (int least = 0; least < 256; ++least) {
    const int first_apart = static_cast<int>(std::ceil(least / (1.0 - uniqueness)));
    near[static_cast<std::size_t>(least)] = static_cast<std::uint8_t>(std::clamp(first_apart - 1, 0, 255));
  }
  return near;
}

}  // namespace

RowMatcher::RowMatcher(const DisparityConfig& config, const StereoPair& pair)
    : too_near_(too_near_of(config.uniqueness)), match_(semi_global::match_row()) {
  cv::copyMakeBorder(as_mat(pair.left), left_, kRim, kRim, kRim, kRim, cv::BORDER_REPLICATE);
  cv::Mat mirrored;
  cv::flip(as_mat(pair.right), mirrored, 1);
  cv::copyMakeBorder(mirrored, right_, kRim, kRim, kRim, kRim, cv::BORDER_REPLICATE);
  const int width = pair.left.width;
  const auto columns = static_cast<std::size_t>(width);
  const auto bytes = static_cast<std::size_t>(semi_global::padded(config.disparities));
  const std::size_t plane = columns + semi_global::kMostDisparities;
  planes_.resize(2 * semi_global::kCensusPlanes * plane);
  costs_.resize(2 * columns * bytes + 2 * (columns + 1) * bytes);
  least_.resize(2 * (columns + 1));
  best_right_.resize(columns);
  row_.width = width;
  row_.disparities = config.disparities;
  row_.small_penalty = static_cast<std::uint8_t>(config.small_penalty);
  row_.large_penalty = static_cast<std::uint8_t>(config.large_penalty);
  row_.plane_bytes = static_cast<int>(plane);
  row_.left = planes_.data();
  row_.right_reversed = planes_.data() + semi_global::kCensusPlanes * plane;
  row_.costs = costs_.data();
  row_.sums = row_.costs + columns * bytes;
  row_.from_left = row_.sums + columns * bytes;
  row_.from_right = row_.from_left + (columns + 1) * bytes;
  row_.from_left_least = least_.data();
  row_.from_right_least = least_.data() + columns + 1;
  row_.too_near = too_near_.data();
  row_.best_right = best_right_.data();
}

FiveRows RowMatcher::left_rows(int row) const {
  return rows_around(left_, row);
}

void RowMatcher::match(int row, std::int16_t* best) {
  std::uint8_t* const planes = planes_.data();
  census_row(rows_around(left_, row), row_.width, false, planes, row_.plane_bytes);
  census_row(rows_around(right_, row), row_.width, true, planes + semi_global::kCensusPlanes * row_.plane_bytes,
             row_.plane_bytes);
  for (int plane = 0; plane < semi_global::kCensusPlanes; ++plane) {
    std::uint8_t* const end = planes + (semi_global::kCensusPlanes + plane) * row_.plane_bytes + row_.width;
    std::fill(end, end + semi_global::kMostDisparities, end[-1]);
  }
  row_.best = best;
  match_(row_);
  for (int x = 0; x < row_.width; ++x) {
    if (best[x] == semi_global::kAmbiguous) continue;
    const int disparity = (best[x] + 8) / 16;
    const int at = x - disparity;
    if (at < 0 || std::abs(best_right_[static_cast<std::size_t>(at)] - disparity) > 1) best[x] = DisparityMap::none;
  }
}

}  // namespace weft::agents
