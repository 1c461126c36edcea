#include "agents/perception/upright_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/upright_scene.hpp"

namespace weft::agents {
namespace {

class UprightFeaturesTest : public testing::TestWithParam<Description> {
 protected:
  static constexpr int kWidth = 320;
  static constexpr int kHeight = 240;

  std::vector<UprightFeature> features(const Image& image) const {
    UprightConfig config;
    config.description = GetParam();
    config.count = 300;
    return upright_features(image, config);
  }
  test::UprightScene scene_{3, 480, 300};
};

/// Returns the share of the features of `a` of which `b` has one with nearly the same descriptor so many pixels away.
double found_again(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b, double right,
                   double down) {
  const auto found = std::count_if(a.begin(), a.end(), [&](const UprightFeature& f) {
    return std::any_of(b.begin(), b.end(), [&](const UprightFeature& other) {
      const Eigen::Vector2f off = other.pixel - f.pixel - Eigen::Vector2f(right, down);
      return off.norm() < 1.5 && hamming(f.descriptor, other.descriptor) < 40;
    });
  });
  return static_cast<double>(found) / static_cast<double>(a.size());
}

TEST_P(UprightFeaturesTest, AreFoundAgainWhereTheImageHasMovedTo) {
  const auto a = features(scene_.view(60, 30, kWidth, kHeight));
  const auto b = features(scene_.view(80, 24, kWidth, kHeight, 1.0, 2.0, 2));
  EXPECT_GT(a.size(), 200U);
  EXPECT_GT(found_again(a, b, -20.0, 6.0), 0.4);
  EXPECT_LT(found_again(a, b, 11.0, 0.0), 0.02) << "what is elsewhere looks otherwise";
}

TEST_P(UprightFeaturesTest, LightThatIsHalvedChangesLittle) {
  const auto a = features(scene_.view(60, 30, kWidth, kHeight));
  const auto b = features(scene_.view(60, 30, kWidth, kHeight, 0.5, 1.0, 2));
  EXPECT_GT(found_again(a, b, 0.0, 0.0), 0.5);
}

TEST_P(UprightFeaturesTest, AreSpreadOverTheImage) {
  const auto all = features(scene_.view(60, 30, kWidth, kHeight));
  for (const float left : {0.0F, 160.0F}) {
    for (const float top : {0.0F, 120.0F}) {
      const auto here = std::count_if(all.begin(), all.end(), [&](const UprightFeature& f) {
        return f.pixel.x() >= left && f.pixel.x() < left + 160 && f.pixel.y() >= top && f.pixel.y() < top + 120;
      });
      EXPECT_GT(here, static_cast<std::ptrdiff_t>(all.size() / 6)) << left << ", " << top;
    }
  }
}

TEST_P(UprightFeaturesTest, SameImageSameFeatures) {
  const auto a = features(scene_.view(60, 30, kWidth, kHeight));
  const auto b = features(scene_.view(60, 30, kWidth, kHeight));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].descriptor, b[i].descriptor);
}

TEST_P(UprightFeaturesTest, NoneOfWhatShowsNothingOrIsTooSmall) {
  const auto blank = [](int width, int height) {
    return Image{width, height, std::make_shared<const Bytes>(static_cast<std::size_t>(width * height), 128)};
  };
  EXPECT_TRUE(features(blank(kWidth, kHeight)).empty());
  EXPECT_TRUE(features(blank(8, 8)).empty());
  EXPECT_TRUE(features(blank(1, 1)).empty());
}

INSTANTIATE_TEST_SUITE_P(Descriptions, UprightFeaturesTest,
                         testing::Values(Description::brief, Description::gradients), [](const auto& tested) {
                           return tested.param == Description::brief ? "brief" : "gradients";
                         });

}  // namespace
}  // namespace weft::agents
