#include "agents/perception/looming.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/random.hpp"

namespace weft::agents {
namespace {

constexpr double kFocalPx = 386.0;

/// Describes how the camera has moved from the origin, where it looks along x at points on racks before it.
struct Moved {
  double ahead_m = 0.0;
  double left_m = 0.0;
  double turned_rad = 0.0;
  double pitched_rad = 0.0;
};

struct Views {
  std::vector<UprightFeature> a, b;
  std::vector<Match> same;
};

UprightFeature seen(const Eigen::Vector3d& point, const Moved& from, double noise_px, Random& random) {
  const Eigen::Vector2d flat =
      Eigen::Rotation2Dd(-from.turned_rad) * Eigen::Vector2d(point.x() - from.ahead_m, point.y() - from.left_m);
  const double up = point.z() + from.pitched_rad * flat.x();
  UprightFeature feature;
  feature.pixel = {static_cast<float>(-kFocalPx * flat.y() / flat.x() + random.normal(0.0, noise_px)),
                   static_cast<float>(-kFocalPx * up / flat.x() + random.normal(0.0, noise_px))};
  return feature;
}

/// Returns two views of things about 4 m away; of the matches the share `wrong` are of something else.
Views views(const Moved& moved, double wrong, std::uint64_t seed) {
  Random random(seed);
  Views views;
  for (std::uint32_t i = 0; i < 80; ++i) {
    const double x = random.uniform(3.0, 5.0);
    const Eigen::Vector3d point(x, random.uniform(-0.3, 0.3) * x, random.uniform(-0.1, 0.3) * x);
    views.a.push_back(seen(point, {}, 0.4, random));
    views.b.push_back(seen(point, moved, 0.4, random));
    if (random.chance(wrong)) views.b.back().pixel.y() += static_cast<float>(random.uniform(-25.0, 25.0));
    views.same.push_back({i, i, 0});
  }
  return views;
}

double told(const Views& views) {
  const auto looming = looming_of(views.a, views.b, views.same, kFocalPx);
  EXPECT_TRUE(looming);
  return looming ? looming->share : NAN;
}

TEST(Looming, TellsByWhichShareThingsAreNearer) {
  for (const double ahead_m : {-0.4, -0.1, 0.0, 0.1, 0.4}) {
    // Of the mean of both distances, which are 4 m and less.
    EXPECT_NEAR(told(views({ahead_m}, 0.0, 1)), ahead_m / (4.0 - 0.5 * ahead_m), 0.006) << ahead_m;
  }
}

TEST(Looming, TurnPitchAndAStepAsideAreNoLooming) {
  EXPECT_NEAR(told(views({0.0, 0.0, 0.2}, 0.0, 2)), 0.0, 0.006);
  EXPECT_NEAR(told(views({0.0, 0.0, 0.0, 0.03}, 0.0, 3)), 0.0, 0.006);
  // A step aside is one on the mean only: what is on the one side comes nearer, on the other further.
  double sum = 0.0;
  for (std::uint64_t seed = 0; seed < 50; ++seed) sum += told(views({0.0, 0.3}, 0.0, 40 + seed));
  EXPECT_NEAR(sum / 50.0, 0.0, 0.003);
}

TEST(Looming, WrongMatchesHardlyCount) {
  EXPECT_NEAR(told(views({0.2}, 0.3, 5)), 0.2 / 3.9, 0.01);
}

TEST(Looming, IsAsSureAsItIsRight) {
  double squares = 0.0;
  constexpr int kViews = 100;
  for (std::uint64_t seed = 0; seed < kViews; ++seed) {
    const Views some = views({0.0}, 0.1, 100 + seed);
    const auto looming = looming_of(some.a, some.b, some.same, kFocalPx);
    ASSERT_TRUE(looming);
    squares += looming->share * looming->share / looming->variance;
  }
  EXPECT_GT(std::sqrt(squares / kViews), 0.6);
  EXPECT_LT(std::sqrt(squares / kViews), 1.5);
}

TEST(Looming, NothingIsSaidOfTooLittle) {
  Views some = views({0.1}, 0.0, 6);
  some.same.resize(5);
  EXPECT_FALSE(looming_of(some.a, some.b, some.same, kFocalPx));
  Views level = views({0.1}, 0.0, 7);
  for (auto* const features : {&level.a, &level.b})
    for (UprightFeature& feature : *features) feature.pixel.y() = 0.0F;
  EXPECT_FALSE(looming_of(level.a, level.b, level.same, kFocalPx)) << "all at one height";
}

}  // namespace
}  // namespace weft::agents
