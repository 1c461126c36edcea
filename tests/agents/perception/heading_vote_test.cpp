#include "agents/perception/heading_vote.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/upright_scene.hpp"

namespace weft::agents {
namespace {

class HeadingVoteTest : public testing::Test {
 protected:
  static constexpr int kWidth = 320;
  static constexpr int kHeight = 240;

  static std::vector<UprightFeature> features(const Image& image) {
    UprightConfig config;
    config.count = 400;
    return upright_features(image, config);
  }
  static auto vote(const Image& a, const Image& b) { return vote_heading(features(a), features(b), kWidth, {}); }

  test::UprightScene scene_{5, 700, 360};
};

TEST_F(HeadingVoteTest, TellsByHowMuchTheViewHasTurned) {
  const Image taught = scene_.view(200, 40, kWidth, kHeight);
  for (const int turned : {-110, -40, -3, 0, 25, 118}) {
    const auto found = vote(taught, scene_.view(200 - turned, 46, kWidth, kHeight, 1.0, 2.0, 7));
    ASSERT_TRUE(found) << turned << ": " << found.error().reason;
    EXPECT_NEAR(found->shift_px, turned, 2.0);
    EXPECT_GT(found->votes, 20U);
    EXPECT_LE(found->votes, found->matches);
    EXPECT_LT(found->runner_up, 0.5);
  }
}

TEST_F(HeadingVoteTest, StandsHalfTheSceneChangedInHalfTheLight) {
  const Image taught = scene_.view(200, 40, kWidth, kHeight);
  test::UprightScene changed = scene_;
  changed.change(0.5, 11);
  const auto found = vote(taught, changed.view(170, 40, kWidth, kHeight, 0.5, 2.0, 8));
  ASSERT_TRUE(found) << found.error().reason;
  EXPECT_NEAR(found->shift_px, 30.0, 3.0);
}

TEST_F(HeadingVoteTest, NearThingsDoNotOutvoteTheMost) {
  // The lower third is near and shifts twice as far.
  auto pixels = std::make_shared<Bytes>(*scene_.view(180, 40, kWidth, kHeight).pixels);
  const Image near = scene_.view(160, 40, kWidth, kHeight);
  const std::ptrdiff_t from = static_cast<std::ptrdiff_t>(kWidth) * (2 * kHeight / 3);
  std::copy(near.pixels->begin() + from, near.pixels->end(), pixels->begin() + from);
  const auto found = vote(scene_.view(200, 40, kWidth, kHeight), {kWidth, kHeight, pixels});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->shift_px, 20.0, 5.0);
}

TEST_F(HeadingVoteTest, OfStrangersNothingIsSaid) {
  int said = 0;
  for (std::uint64_t seed = 20; seed < 40; ++seed) {
    const test::UprightScene other(seed, 700, 320);
    const auto found = vote(scene_.view(200, 40, kWidth, kHeight), other.view(200, 40, kWidth, kHeight));
    said += found ? 1 : 0;
    if (!found) {
      EXPECT_EQ(found.error().reason, "no_majority");
      EXPECT_LT(found.error().measured, found.error().bound);
    }
  }
  EXPECT_LE(said, 2);
}

TEST_F(HeadingVoteTest, ACameraThatLooksFurtherDownSeesTheSameFurtherUp) {
  const auto taught = features(scene_.view(200, 40, kWidth, kHeight));
  for (const int lower : {-36, 45, 70}) {
    const auto seen = features(scene_.view(170, 40 + lower, kWidth, kHeight, 1.0, 2.0, 7));
    const double rise_px = frequent_rise(taught, seen, kWidth, {});
    EXPECT_NEAR(rise_px, -lower, 3.0);
    const auto found = vote_heading(taught, seen, kWidth, {}, rise_px);
    ASSERT_TRUE(found) << lower << ": " << found.error().reason;
    EXPECT_NEAR(found->shift_px, 30.0, 2.0);
  }
  const auto unknowing =
      vote_heading(taught, features(scene_.view(170, 110, kWidth, kHeight, 1.0, 2.0, 7)), kWidth, {});
  EXPECT_FALSE(unknowing && std::abs(unknowing->shift_px - 30.0) < 5.0);
}

TEST_F(HeadingVoteTest, WhatAVoteStandsAnywayIsNoRise) {
  const auto taught = features(scene_.view(200, 40, kWidth, kHeight));
  EXPECT_EQ(frequent_rise(taught, features(scene_.view(190, 50, kWidth, kHeight, 1.0, 2.0, 7)), kWidth, {}), 0.0);
  EXPECT_EQ(
      frequent_rise(taught,
                    features(Image{kWidth, kHeight,
                                   std::make_shared<const Bytes>(static_cast<std::size_t>(kWidth * kHeight), 90)}),
                    kWidth, {}),
      0.0);
}

TEST_F(HeadingVoteTest, TooFewFeaturesAreCounted) {
  const Image blank{kWidth, kHeight, std::make_shared<const Bytes>(static_cast<std::size_t>(kWidth * kHeight), 90)};
  const auto found = vote(scene_.view(200, 40, kWidth, kHeight), blank);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().reason, "few_features");
  EXPECT_EQ(found.error().measured, 0.0);
  EXPECT_EQ(found.error().bound, 20.0);
}

}  // namespace
}  // namespace weft::agents
