#include "agents/perception/stereo/disparity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <opencv2/core.hpp>
#include <string>

#include "agents/perception/opencv_view.hpp"
#include "agents/perception/stereo/census.hpp"
#include "agents/perception/stereo/pair_light.hpp"
#include "agents/perception/stereo/semi_global.hpp"
#include "agents/perception/stereo/speckles.hpp"
#include "agents/perception/stereo/texture_gate.hpp"

namespace weft::agents {
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

/// Matches row after row, from the top on.
class RowMatcher {
 public:
  RowMatcher(const DisparityConfig& config, const StereoPair& pair)
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

  FiveRows left_rows(int row) const { return rows_around(left_, row); }

  /// Writes the row's disparities: none where it is ambiguous, or the right image says otherwise.
  void match(int row, std::int16_t* best) {
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

 private:
  std::array<std::uint8_t, 256> too_near_;
  semi_global::MatchRow match_;
  cv::Mat left_, right_;  // with rims; the right one from right to left
  std::vector<std::uint8_t> planes_, costs_, least_, best_right_;
  semi_global::Row row_;
};
static_assert(semi_global::kAmbiguous == DisparityMap::none);

/// Leaves disparities only where there is texture, and returns how many pixels have some.
std::size_t gate_row(const std::uint8_t* is_textured, int width, std::int16_t* values) {
  std::size_t textured = 0;
  for (int x = 0; x < width; ++x) {
    textured += is_textured[x];
    if (is_textured[x] == 0) values[x] = DisparityMap::none;
  }
  return textured;
}

}  // namespace

Result<void> check(const DisparityConfig& c) {
  const auto wrong = [](const std::string& what) { return fail(ErrorCode::invalid, "disparity: " + what); };
  if (c.disparities < 16 || c.disparities > semi_global::kMostDisparities || c.disparities % 16 != 0)
    return wrong("disparities = " + std::to_string(c.disparities) + " is no multiple of 16 within 16..128");
  if (c.small_penalty < 1 || c.large_penalty < c.small_penalty || c.large_penalty > semi_global::kMostPenalty)
    return wrong("small_penalty = " + std::to_string(c.small_penalty) + " and large_penalty = " +
                 std::to_string(c.large_penalty) + " are not within 1..39, the smaller one first");
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  if (!within(c.uniqueness, 0.0, 0.5)) return wrong("uniqueness is not within 0..0.5");
  if (!within(c.least_texture, 0.0, 200.0)) return wrong("least_texture is not within 0..200");
  if (!within(c.least_patch_px, 0, 100'000)) return wrong("least_patch_px is not within 0..100000");
  if (!within(c.patch_step_px, 0.0, 16.0)) return wrong("patch_step_px is not within 0..16");
  if (!within(c.least_light, 0.0, 255.0)) return wrong("least_light is not within 0..255");
  if (!within(c.least_likeness, 0.0, 1.0)) return wrong("least_likeness is not within 0..1");
  if (!within(c.least_matched, 0.0, 1.0)) return wrong("least_matched is not within 0..1");
  return {};
}

double density(const DisparityMap& map) {
  if (map.sixteenths.empty()) return 0.0;
  const auto none = std::count(map.sixteenths.begin(), map.sixteenths.end(), DisparityMap::none);
  return 1.0 - static_cast<double>(none) / static_cast<double>(map.sixteenths.size());
}

OrUnseen<DisparityMap> match_disparity(const DisparityConfig& config, const StereoPair& rectified) {
  if (const auto refused = too_little_light({config.least_light, config.least_likeness}, rectified))
    return tl::unexpected(*refused);
  const int width = rectified.left.width;
  const int height = rectified.left.height;
  DisparityMap map{width, height, {}};
  map.sixteenths.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  RowMatcher matcher(config, rectified);
  TextureGate gate(width, height, config.least_texture);
  std::size_t textured = 0;
  std::int16_t* told = map.sixteenths.data();
  const auto tell = [&] {
    if (const std::uint8_t* const is_textured = gate.told()) {
      textured += gate_row(is_textured, width, told);
      told += width;
    }
  };
  for (int row = 0; row < height; ++row) {
    matcher.match(row, map.sixteenths.data() + static_cast<std::ptrdiff_t>(row) * width);
    gate.take(matcher.left_rows(row));
    tell();
  }
  while (told != map.sixteenths.data() + map.sixteenths.size()) tell();
  remove_speckles(map.sixteenths, width, config.least_patch_px,
                  static_cast<int>(std::lround(16.0 * config.patch_step_px)), DisparityMap::none);
  // Patches of two views that have nothing in common agree by chance; they are small.
  const double matched = density(map) * static_cast<double>(map.sixteenths.size());
  const double share = textured > 0 ? matched / static_cast<double>(textured) : 1.0;
  if (share < config.least_matched) return tl::unexpected(Unseen{"decorrelated", share, config.least_matched});
  return map;
}

std::vector<DepthPoint> points_of(const DisparityMap& map, const StereoRig& rig, double range_m,
                                  double disparity_sigma_px, int every) {
  std::vector<DepthPoint> points;
  const double least_px = rig.disparity_px(range_m);
  for (int row = 0; row < map.height; row += every)
    for (int column = 0; column < map.width; column += every) {
      const std::optional<double> disparity = map.at(column, row);
      if (!disparity || *disparity <= 0.0 || *disparity < least_px) continue;
      const Eigen::Vector3d point = rig.point_of(column, row, *disparity);
      points.push_back({point.cast<float>(), static_cast<float>(rig.depth_sigma_m(point.z(), disparity_sigma_px)),
                        row * map.width + column});
    }
  return points;
}

}  // namespace weft::agents
