#include "agents/bodies/sim/hall/bloom.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace weft::agents::sim {
namespace {

constexpr std::size_t kColumns = 40;
constexpr std::size_t kRows = 30;

/// Returns an image, in blocks, that is dark but for one bright block in its middle.
std::vector<float> lamp_in_the_dark() {
  std::vector<float> light(kColumns * kRows * 16, 0.0F);
  const std::size_t block = kRows / 2 * kColumns + kColumns / 2;
  std::fill_n(light.begin() + static_cast<std::ptrdiff_t>(block * 16), 16, 1000.0F);
  return light;
}

float block_at(const std::vector<float>& light, std::size_t columns_beside) {
  const std::size_t block = kRows / 2 * kColumns + kColumns / 2 + columns_beside;
  return std::accumulate(light.begin() + static_cast<std::ptrdiff_t>(block * 16),
                         light.begin() + static_cast<std::ptrdiff_t>(block * 16 + 16), 0.0F) /
         16.0F;
}

TEST(Bloom, SpreadsLightAboutWhatIsBright) {
  std::vector<float> light = lamp_in_the_dark();
  Bloom(kColumns, kRows, 0.1).scatter(light);
  EXPECT_NEAR(block_at(light, 0), 900.0F, 30.0F);
  EXPECT_GT(block_at(light, 1), 2.0F);
  EXPECT_GT(block_at(light, 1), 2.0F * block_at(light, 4));
  EXPECT_GT(block_at(light, 4), block_at(light, 10));
  EXPECT_GT(block_at(light, 10), 0.0F);
}

TEST(Bloom, LosesNoLight) {
  std::vector<float> light = lamp_in_the_dark();
  Bloom(kColumns, kRows, 0.2).scatter(light);
  EXPECT_NEAR(std::accumulate(light.begin(), light.end(), 0.0), 16'000.0, 160.0);
}

TEST(Bloom, OfNothingChangesNothing) {
  std::vector<float> light = lamp_in_the_dark();
  Bloom(kColumns, kRows, 0.0).scatter(light);
  EXPECT_EQ(light, lamp_in_the_dark());
}

}  // namespace
}  // namespace weft::agents::sim
