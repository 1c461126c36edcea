#include "agents/perception/revisited_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/flat_floor.hpp"

namespace weft::agents {
namespace {

class RevisitedView : public testing::Test {
 protected:
  Image look(const Pose2& at, double noise, std::uint64_t seed = 1, double gain = 1.0) const {
    test::Shot shot;
    shot.noise = noise;
    shot.seed = seed;
    shot.gain = gain;
    return eye.render(floor, at, {}, shot);
  }
  /// Returns the mean difference of the grey levels in the middle of the image, which both show.
  static double apart(const Image& a, const Image& b) {
    const cv::Rect middle(a.width / 4, a.height / 4, a.width / 2, a.height / 2);
    cv::Mat difference;
    cv::absdiff(as_mat(a)(middle), as_mat(b)(middle), difference);
    return cv::mean(difference)[0];
  }
  static double brightness(const Image& image) { return cv::mean(as_mat(image))[0]; }

  const CameraModel camera = test::paper_camera();
  const test::FlatFloor floor = test::FlatFloor::procedural(4, 6.0, 4.0);
  const test::FloorCamera eye{camera};
  const Pose2 here{2.0, 2.0, 0.3};
};

TEST_F(RevisitedView, NoiseIsToldFromAFloorsTexture) {
  const test::FlatFloor plain = test::FlatFloor::blank(6.0, 4.0);
  for (const double sigma : {1.0, 2.0, 5.0}) {
    test::Shot shot;
    shot.noise = sigma;
    EXPECT_NEAR(noise_of(eye.render(plain, here, {}, shot)), sigma, 0.15 * sigma);
  }
  EXPECT_LT(noise_of(look(here, 2.0)), 4.0);
}

TEST_F(RevisitedView, ARobotBesideSeesWhatIsThere) {
  OtherLook other;
  other.robot_from_other = {0.0, 0.06, -0.05};
  other.attitude = {0.006, -0.004, 0.003};
  const Image seen = revisited_view(look(here, 1.0), camera, other);
  test::Shot shot;
  shot.noise = 1.0;
  shot.seed = 2;
  const Image truly = eye.render(floor, here * other.robot_from_other, other.attitude, shot);
  EXPECT_LT(apart(seen, truly), 0.3 * apart(look(here, 1.0), truly));
}

TEST_F(RevisitedView, WhatIsDarkerIsTheSameViewWithAsMuchNoise) {
  const Image seen = look(here, 2.0);
  const Image dark = darker(seen, 0.5, 3);
  EXPECT_EQ(dark.width, seen.width);
  EXPECT_NEAR(brightness(dark), 0.5 * brightness(seen), 1.0);
  EXPECT_NEAR(noise_of(darker(look(here, 0.0), 0.5, 3)), 0.5 * noise_of(look(here, 0.0)), 1.0);
  EXPECT_EQ(*darker(seen, 0.5, 3).pixels, *dark.pixels);
  EXPECT_NE(*darker(seen, 0.5, 4).pixels, *dark.pixels);
}

TEST_F(RevisitedView, InHalfTheLightTheNoiseStays) {
  OtherLook other;
  other.light = 0.5;
  const Image image = look(here, 3.0);
  const Image seen = revisited_view(image, camera, other);
  EXPECT_NEAR(brightness(seen), 0.5 * brightness(image), 1.0);
  const Image truly = look(here, 3.0, 2, 0.5);
  EXPECT_NEAR(noise_of(seen), noise_of(truly), 0.15 * noise_of(truly));
}

TEST_F(RevisitedView, WearCoversPartOfTheFloor) {
  OtherLook other;
  other.wear = FloorWear{};
  const Image image = look(here, 0.0);
  const Image seen = revisited_view(image, camera, other);
  cv::Mat change;
  cv::absdiff(as_mat(seen), as_mat(image), change);
  const double covered = cv::countNonZero(change > 12) / static_cast<double>(change.total());
  EXPECT_GT(covered, 0.005);
  EXPECT_LT(covered, 0.2);
}

TEST_F(RevisitedView, EachSeedIsAnotherWearAndTheSameSeedTheSame) {
  OtherLook other;
  other.wear = FloorWear{};
  other.seed = 7;
  const Image image = look(here, 2.0);
  const Image once = revisited_view(image, camera, other);
  EXPECT_EQ(*revisited_view(image, camera, other).pixels, *once.pixels);
  other.seed = 8;
  EXPECT_NE(*revisited_view(image, camera, other).pixels, *once.pixels);
  EXPECT_NE(blots_of({}, 7).front().grey, blots_of({}, 8).front().grey);
}

}  // namespace
}  // namespace weft::agents
