#include "agents/perception/plane/repetition.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "core/random.hpp"

namespace weft::agents {
namespace {

/// Makes features as on a plane without order; some can be put down again elsewhere.
struct Stretch {
  std::vector<PlaneFeature> features;
  std::vector<Eigen::Vector2d> at;
  Random random{5};

  explicit Stretch(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      PlaneFeature feature;
      feature.on_plane = {random.uniform(0.4, 1.0), random.uniform(-0.6, 0.0)};
      feature.heading_rad = random.uniform(-3.0, 3.0);
      for (std::uint64_t& word : feature.descriptor) word = random.next();
      add(feature);
    }
  }
  void add(const PlaneFeature& feature) {
    features.push_back(feature);
    at.push_back(feature.on_plane);
  }
  /// Adds all within a square around the stretch's middle once more, seen a little differently.
  void again(const Pose2& moved, double half_m) {
    const std::size_t count = features.size();
    for (std::size_t i = 0; i < count; ++i) {
      PlaneFeature feature = features[i];
      if ((feature.on_plane - Eigen::Vector2d(0.7, -0.3)).cwiseAbs().maxCoeff() > half_m) continue;
      feature.on_plane = moved * feature.on_plane + Eigen::Vector2d(0.002 * random.normal(), 0.002 * random.normal());
      feature.heading_rad = wrap_angle(feature.heading_rad + moved.heading);
      for (int bit = 0; bit < 20; ++bit) feature.descriptor[random.below(4)] ^= 1ULL << random.below(64);
      add(feature);
    }
  }
  Repetition find(std::size_t count, double reach_m) const {
    std::vector<std::uint32_t> first(count);
    std::iota(first.begin(), first.end(), 0U);
    return find_repetition(RepetitionBounds{}, features, at, first, reach_m);
  }
};

constexpr std::size_t kCount = 150;

TEST(Repetition, APlaneWithoutOrderMeetsItselfNowhere) {
  const Stretch stretch(2 * kCount);
  EXPECT_LT(stretch.find(kCount, kAnywhereM).agreeing, 8U);
}

TEST(Repetition, AShiftedCopyIsFoundWithItsShift) {
  Stretch stretch(kCount);
  stretch.again({0.05, 0.7, 0.0}, 1.0);
  for (const double reach_m : {kAnywhereM, 0.8}) {
    const Repetition again = stretch.find(kCount, reach_m);
    EXPECT_GT(again.agreeing, kCount * 8 / 10);
    EXPECT_GT(again.spread, 0.8);
    EXPECT_NEAR(again.moved.y, 0.7, 0.01);
    EXPECT_NEAR(again.moved.heading, 0.0, 0.03);
  }
}

TEST(Repetition, WhatLiesBeyondReachIsLeftAlone) {
  Stretch stretch(kCount);
  stretch.again({0.05, 0.7, 0.0}, 1.0);
  EXPECT_LT(stretch.find(kCount, 0.6).agreeing, 8U);
}

TEST(Repetition, ATurnedCopyCountsWhereNothingIsGuessed) {
  Stretch stretch(kCount);
  stretch.again({0.0, 1.3, 1.6}, 1.0);
  EXPECT_GT(stretch.find(kCount, kAnywhereM).agreeing, kCount * 8 / 10);
  EXPECT_LT(stretch.find(kCount, 3.0).agreeing, 8U);
}

TEST(Repetition, APatchThatComesAgainIsSmall) {
  Stretch stretch(kCount);
  stretch.again({0.0, 0.7, 0.0}, 0.1);
  const Repetition again = stretch.find(kCount, kAnywhereM);
  EXPECT_GT(again.agreeing, 5U);
  EXPECT_LT(again.spread, 0.4);
}

TEST(Repetition, TwinsAreCountedWhereverTheyLie) {
  Stretch stretch(kCount);
  EXPECT_LT(share_with_twins(stretch.features, stretch.at, 50, 0.3), 0.05) << "without order";
  stretch.again({0.05, 0.7, 1.0}, 1.0);
  EXPECT_EQ(share_with_twins(stretch.features, stretch.at, 50, 0.05), 1.0);
  EXPECT_EQ(share_with_twins(stretch.features, stretch.at, 50, 5.0), 0.0) << "none lies so far away";
  EXPECT_EQ(share_with_twins({}, {}, 50, 0.3), 0.0);
}

TEST(Repetition, NothingIsNoRepetition) {
  EXPECT_EQ(Stretch(0).find(0, kAnywhereM).agreeing, 0U);
  EXPECT_EQ(Stretch(1).find(1, kAnywhereM).agreeing, 0U);
}

}  // namespace
}  // namespace weft::agents
