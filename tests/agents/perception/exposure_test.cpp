#include "agents/perception/exposure.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "core/random.hpp"

namespace weft::agents {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

/// Shows what a sensor at a given exposure makes of light, with its noise.
class Scene {
 public:
  /// Makes boards of all greys between `darkest` and `brightest`, some of the light that is white at exposure 1 =
  /// 255.
  Scene(double darkest, double brightest) : light_(kWidth * kHeight) {
    constexpr int board = 8;
    Random random(7);
    std::vector<double> boards(kWidth / board * (kHeight / board));
    for (double& grey : boards) grey = random.uniform(darkest, brightest);
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x)
        at(x, y) = boards[static_cast<std::size_t>(y / board * (kWidth / board) + x / board)];
  }
  void brighten(int from_column, int to_column, double factor) {
    for (int y = 0; y < kHeight; ++y)
      for (int x = from_column; x < to_column; ++x) at(x, y) *= factor;
  }
  void set(int from_column, int to_column, double light) {
    for (int y = 0; y < kHeight; ++y)
      for (int x = from_column; x < to_column; ++x) at(x, y) = light;
  }

  Image taken(double exposure) {
    auto pixels = std::make_shared<Bytes>(light_.size());
    for (std::size_t i = 0; i < light_.size(); ++i)
      (*pixels)[i] = static_cast<std::uint8_t>(std::clamp(exposure * light_[i] + random_.normal(), 0.0, 255.0));
    return {kWidth, kHeight, std::move(pixels)};
  }
  /// Returns the exposures of so many images, each as the one before it wishes.
  std::vector<double> told(double first, int images) {
    std::vector<double> all{first};
    for (int i = 0; i < images; ++i) all.push_back(all.back() * exposure_factor(taken(all.back()), 1.0, {}));
    return all;
  }
  /// Returns the share of the scene that shows: neither white nor lost in the noise.
  double shows(double exposure) const {
    return static_cast<double>(
               std::count_if(light_.begin(), light_.end(),
                             [&](double light) { return exposure * light > 20.0 && exposure * light < 250.0; })) /
           static_cast<double>(light_.size());
  }

 private:
  double& at(int x, int y) { return light_[static_cast<std::size_t>(y * kWidth + x)]; }

  std::vector<double> light_;
  Random random_{3};
};

TEST(ExposureFactor, WhatIsTooDarkIsExposedLongerAndWhatIsWhiteShorter) {
  Scene scene(20.0, 200.0);
  EXPECT_GT(exposure_factor(scene.taken(0.1), 1.0, {}), 1.3);
  EXPECT_LT(exposure_factor(scene.taken(6.0), 1.0, {}), 0.8);
}

TEST(ExposureFactor, SettlesAtOneExposureFromBothSidesWithoutSwinging) {
  Scene scene(20.0, 200.0);
  const std::vector<double> from_dark = scene.told(0.03, 16);
  const std::vector<double> from_white = scene.told(20.0, 16);
  EXPECT_NEAR(std::log2(from_dark.back() / from_white.back()), 0.0, 0.4);
  EXPECT_GT(scene.shows(from_dark.back()), 0.9);
  EXPECT_GT(scene.shows(from_white.back()), 0.9);
  for (std::size_t i = 0; i + 1 < from_dark.size(); ++i) {
    EXPECT_GE(from_dark[i + 1] / from_dark[i], 0.97) << i;
    EXPECT_LE(from_white[i + 1] / from_white[i], 1.03) << i;
  }
  for (std::size_t i = 12; i + 1 < from_dark.size(); ++i)
    EXPECT_NEAR(from_dark[i + 1] / from_dark[i], 1.0, 0.03) << i;
}

/// Shows that a lamp changes little; by a mean of grey levels everything else would go dark.
TEST(ExposureFactor, ALampInThePictureChangesLittle) {
  Scene without(20.0, 200.0);
  Scene with(20.0, 200.0);
  with.set(60, 90, 3000.0);
  EXPECT_NEAR(std::log2(with.told(1.0, 16).back() / without.told(1.0, 16).back()), 0.0, 0.4);
}

/// Shows that what is lit keeps showing; by a mean it would go white, as most of the picture shows nothing at all.
TEST(ExposureFactor, WhatIsLitInTheDarkIsNotGivenUpForTheDark) {
  Scene scene(20.0, 200.0);
  scene.set(0, 110, 0.2);
  const double settled = scene.told(1.0, 16).back();
  EXPECT_LT(settled, 2.0);
  EXPECT_GT(settled, 0.7);
}

TEST(ExposureFactor, OfTwoHalvesItTakesAnExposureThatShowsBoth) {
  Scene scene(20.0, 200.0);
  scene.brighten(0, kWidth / 2, 0.2);
  const double settled = scene.told(1.0, 16).back();
  EXPECT_GT(scene.shows(settled), 0.75);
}

TEST(ExposureFactor, WhereNothingShowsItLooksForTheMiddleOfTheScale) {
  for (const double light : {0.5, 20.0, 110.0, 20000.0}) {
    Scene scene(light, light);
    const double settled = scene.told(1.0, 40).back();
    EXPECT_GT(settled * light, 60.0) << light;
    EXPECT_LT(settled * light, 250.0) << light;
  }
}

TEST(ExposureFactor, IsBoundedAndDamped) {
  Scene scene(0.0, 1.0);
  ExposureConfig config;
  config.followed = 1.0;
  const double at_once = exposure_factor(scene.taken(1.0), 1.0, config);
  EXPECT_LE(at_once, 4.0);
  EXPECT_GT(at_once, 2.0);
  config.followed = 0.5;
  EXPECT_LE(exposure_factor(scene.taken(1.0), 1.0, config), 2.0);
}

TEST(ExposureFactor, WhatNoiseShowsInAnAmplifiedImageIsNothing) {
  Random random(5);
  auto pixels = std::make_shared<Bytes>(kWidth * kHeight);
  for (std::uint8_t& grey : *pixels)
    grey = static_cast<std::uint8_t>(std::clamp(160.0 + 4.0 * random.normal(), 0.0, 255.0));
  const Image noisy{kWidth, kHeight, std::move(pixels)};
  EXPECT_GE(exposure_factor(noisy, 1.0, {}), 1.0) << "taken for something to be seen";
  EXPECT_LT(exposure_factor(noisy, 64.0, {}), 1.0);
}

TEST(Brightened, ExposesLongerFirstAndAmplifiesWhatWouldBlur) {
  const ExposureConfig config;
  const Exposure slow = brightened({0.004, 1.0}, 2.0, 10.0, config);
  EXPECT_NEAR(slow.time_s, 0.008, 1e-12);
  EXPECT_NEAR(slow.gain, 1.0, 1e-12);
  const Exposure turning = brightened({0.004, 1.0}, 2.0, 500.0, config);
  EXPECT_NEAR(turning.time_s * 500.0, config.most_blur_px, 1e-9);
  EXPECT_NEAR(turning.light_s(), 0.008, 1e-12);
  const Exposure dark = brightened({0.02, 3.0}, 2.0, 0.0, config);
  EXPECT_NEAR(dark.time_s, config.longest_time_s, 1e-12);
  EXPECT_NEAR(dark.gain, 6.0, 1e-9);
}

TEST(Brightened, AmplifiesLessFirstWhenThereIsLightAgain) {
  const Exposure less = brightened({0.02, 3.0}, 0.5, 0.0, {});
  EXPECT_NEAR(less.time_s, 0.02, 1e-12);
  EXPECT_NEAR(less.gain, 1.5, 1e-12);
}

}  // namespace
}  // namespace weft::agents
