#include "agents/perception/stereo/disparity.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>

#include "agents/perception/opencv_view.hpp"
#include "agents/perception/robust.hpp"
#include "agents/perception/stereo/pair_light.hpp"
#include "agents/perception/stereo/row_matcher.hpp"
#include "agents/perception/stereo/speckles.hpp"
#include "agents/perception/stereo/texture_gate.hpp"

namespace weft::agents {
namespace {

/// Leaves disparities only where there is texture, and returns how many pixels have some.
std::size_t gate_row(const std::uint8_t* is_textured, int width, std::int16_t* values) {
  std::size_t textured = 0;
  for (int x = 0; x < width; ++x) {
    textured += is_textured[x];
    if (is_textured[x] == 0) values[x] = DisparityMap::none;
  }
  return textured;
}

/// Holds what both images agree on, and how many pixels have the texture for it.
struct Agreed {
  DisparityMap map;
  std::size_t textured = 0;

  double share_of(std::size_t pixels) const {
    return textured > 0 ? static_cast<double>(pixels) / static_cast<double>(textured) : 1.0;
  }
};

Agreed agreed(const DisparityConfig& config, const StereoPair& pair) {
  const int width = pair.left.width;
  const int height = pair.left.height;
  Agreed agreed{{width, height, {}}};
  std::vector<std::int16_t>& values = agreed.map.sixteenths;
  values.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  RowMatcher matcher(config, pair);
  TextureGate gate(width, height, config.least_texture);
  std::int16_t* told = values.data();
  const auto tell = [&] {
    if (const std::uint8_t* const is_textured = gate.told()) {
      agreed.textured += gate_row(is_textured, width, told);
      told += width;
    }
  };
  for (int row = 0; row < height; ++row) {
    matcher.match(row, values.data() + static_cast<std::ptrdiff_t>(row) * width);
    gate.take(matcher.left_rows(row));
    tell();
  }
  while (told != values.data() + values.size()) tell();
  remove_speckles(values, width, config.least_patch_px, static_cast<int>(std::lround(16.0 * config.patch_step_px)),
                  DisparityMap::none);
  return agreed;
}

Image reduced(const Image& image, int parts) {
  const cv::Size size(image.width / parts, image.height / parts);
  Bytes pixels(static_cast<std::size_t>(size.area()));
  cv::Mat out(size, CV_8UC1, pixels.data());
  cv::resize(as_mat(image), out, size, 0.0, 0.0, cv::INTER_AREA);
  return {size.width, size.height, std::make_shared<const Bytes>(std::move(pixels))};
}

/// Returns the median disparity of what is nearer than was searched, if that is what hides the pair's likeness: at a
/// quarter of the size, where four times as many disparities are searched, both images agree beyond the bound on as
/// much as is wanted.
std::optional<double> nearer_than_searched(const DisparityConfig& config, const StereoPair& pair) {
  constexpr int parts = 4;
  constexpr int narrowest_px = 32;
  constexpr int least_patch_px = 25;  // fewer agree by chance
  if (pair.left.width < parts * narrowest_px || pair.left.height < parts * narrowest_px) return std::nullopt;
  const StereoPair quarter{reduced(pair.left, parts), reduced(pair.right, parts)};
  DisparityConfig coarse = config;
  coarse.disparities = std::min(semi_global::kMostDisparities, quarter.left.width / 16 * 16);
  coarse.least_patch_px = least_patch_px;
  const Agreed found = agreed(coarse, quarter);
  std::vector<double> beyond_px;
  for (const std::int16_t value : found.map.sixteenths)
    if (value != DisparityMap::none && parts * value > 16 * (config.disparities - 2))
      beyond_px.push_back(parts * value / 16.0);
  if (beyond_px.empty() || found.share_of(beyond_px.size()) < config.least_matched) return std::nullopt;
  return median_of(std::move(beyond_px));
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
  Agreed found = agreed(config, rectified);
  // Patches of two views that have nothing in common agree by chance; they are small.
  const double matched = density(found.map) * static_cast<double>(found.map.sixteenths.size());
  const double share = found.share_of(static_cast<std::size_t>(std::lround(matched)));
  if (share >= config.least_matched) return std::move(found.map);
  if (const auto near_px = nearer_than_searched(config, rectified))
    return tl::unexpected(Unseen{"too_near", *near_px, config.disparities - 2.0});
  return tl::unexpected(Unseen{"decorrelated", share, config.least_matched});
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
