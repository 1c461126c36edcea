#include "agents/perception/scaled_descriptors.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "core/random.hpp"

namespace weft::agents {
namespace {

/// Returns an image of blobs, `scale` pixels for each of those of scale 1.
Image blobs(double scale) {
  constexpr double reach_sigmas = 3.0;
  Random random(5);
  Image image{static_cast<int>(320 * scale), static_cast<int>(240 * scale), nullptr};
  std::vector<double> greys(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 128.0);
  for (int i = 0; i < 2500; ++i) {
    const Eigen::Vector2d middle = scale * Eigen::Vector2d(random.uniform(0, 320), random.uniform(0, 240));
    const double sigma = scale * random.uniform(1.5, 3.5);
    const double grey = random.uniform(-70, 70);
    const auto first = [&](double at) { return std::max(0, static_cast<int>(at - reach_sigmas * sigma)); };
    const auto end = [&](double at, int size) { return std::min(size, static_cast<int>(at + reach_sigmas * sigma)); };
    for (int row = first(middle.y()); row < end(middle.y(), image.height); ++row)
      for (int column = first(middle.x()); column < end(middle.x(), image.width); ++column)
        greys[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
              static_cast<std::size_t>(column)] +=
            grey * std::exp(-0.5 * (Eigen::Vector2d(column, row) - middle).squaredNorm() / (sigma * sigma));
  }
  Bytes pixels;
  for (const double grey : greys)
    pixels.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(grey), 0L, 255L)));
  image.pixels = std::make_shared<const Bytes>(std::move(pixels));
  return image;
}

TEST(ScaledDescriptors, OfOnePointAreAlikeFromNearAndFromAfar) {
  const Image far = blobs(1.0);
  const Image near = blobs(2.0);
  std::vector<ScaledPoint> in_far, in_near, unscaled;
  Random random(2);
  for (int i = 0; i < 60; ++i) {
    const Eigen::Vector2d at(random.uniform(40, 280), random.uniform(40, 200));
    in_far.push_back({at, 5.0});
    in_near.push_back({2.0 * at, 10.0});
    unscaled.push_back({2.0 * at, 5.0});
  }
  const auto from_far = describe_at_scale(far, in_far);
  const auto from_near = describe_at_scale(near, in_near);
  const auto as_if_far = describe_at_scale(near, unscaled);
  double scaled_bits = 0.0;
  double unscaled_bits = 0.0;
  for (std::size_t i = 0; i < in_far.size(); ++i) {
    ASSERT_TRUE(from_far[i] && from_near[i] && as_if_far[i]);
    scaled_bits += hamming(*from_far[i], *from_near[i]) / 60.0;
    unscaled_bits += hamming(*from_far[i], *as_if_far[i]) / 60.0;
  }
  EXPECT_LT(scaled_bits, 45.0);
  EXPECT_LT(scaled_bits, 0.6 * unscaled_bits);
}

TEST(ScaledDescriptors, NearTheRimThereIsNone) {
  const Image image = blobs(0.5);
  const auto found = describe_at_scale(image, std::vector<ScaledPoint>{{{3.0, 60.0}, 5.0}, {{80.0, 60.0}, 5.0}});
  EXPECT_FALSE(found[0]);
  EXPECT_TRUE(found[1]);
  EXPECT_TRUE(describe_at_scale(image, {}).empty());
}

}  // namespace
}  // namespace weft::agents
