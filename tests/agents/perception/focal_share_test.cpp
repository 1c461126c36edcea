#include "agents/perception/focal_share.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "core/random.hpp"

namespace weft::agents {
namespace {

constexpr double kNominalFocalPx = 386.0;
constexpr double kSaidTo = 0.02;

/// Describes places each 0.2 m, and a robot among them that is taken to be at 0.
struct Passage {
  double truly_m = 0.0;
  double aside_m = 0.0;
  double focal_share = 0.0;
  double nearest_m = 1.5;  ///< things are from there
  double furthest_m = 7.0;
  double wrong = 0.0;  ///< matches
  std::uint64_t seed = 1;
};

struct PassageViews {
  std::vector<std::vector<UprightFeature>> places;
  std::vector<UprightFeature> seen;
  std::vector<std::vector<Match>> same;
  std::vector<double> at_m;
};

UprightFeature look(const Eigen::Vector3d& thing, double from_m, double aside_m, double focal, double pitch,
                    Random& random) {
  const double ahead = thing.x() - from_m;
  UprightFeature feature;
  feature.pixel = {static_cast<float>(focal * -(thing.y() - aside_m) / ahead + random.normal(0.0, 0.4)),
                   static_cast<float>(focal * (-thing.z() / ahead + pitch) + random.normal(0.0, 0.4))};
  return feature;
}

PassageViews views(const Passage& passage) {
  Random random(passage.seed);
  PassageViews views;
  std::vector<Eigen::Vector3d> things;
  for (int i = 0; i < 90; ++i) {
    const double x = random.uniform(passage.nearest_m, passage.furthest_m);
    things.emplace_back(x, random.uniform(-0.35, 0.35) * x, random.uniform(-0.15, 0.3) * x);
  }
  const double pitch = random.normal(0.0, 0.005);
  for (const Eigen::Vector3d& thing : things)
    views.seen.push_back(
        look(thing, passage.truly_m, passage.aside_m, kNominalFocalPx * (1.0 + passage.focal_share), pitch, random));
  for (int k = -3; k <= 3; ++k) {
    views.at_m.push_back(0.2 * k);
    views.places.emplace_back();
    views.same.emplace_back();
    const double there = random.normal(0.0, 0.005);
    for (std::uint32_t i = 0; i < things.size(); ++i) {
      views.places.back().push_back(look(things[i], 0.2 * k, 0.0, kNominalFocalPx, there, random));
      if (random.chance(0.35)) continue;  // not known again
      const auto other = static_cast<std::uint32_t>(random.uniform(0.0, static_cast<double>(i)));
      views.same.back().push_back({random.chance(passage.wrong) ? other : i, i, 0});
    }
  }
  return views;
}

std::optional<FocalShare> measured(const PassageViews& views) {
  std::vector<OtherView> others;
  for (std::size_t k = 0; k < views.places.size(); ++k)
    others.push_back({views.at_m[k], &views.places[k], &views.same[k]});
  return focal_share_of(others, views.seen, kNominalFocalPx);
}

TEST(FocalShareOf, IsToldWhereverTheRobotIs) {
  for (const double share : {-0.03, 0.0, 0.015, 0.03}) {
    for (const double truly_m : {-0.2, 0.0, 0.07, 0.3}) {
      const auto found = measured(views({.truly_m = truly_m, .focal_share = share, .seed = 3}));
      ASSERT_TRUE(found);
      EXPECT_NEAR(found->share, share, 0.008) << truly_m;
    }
  }
}

TEST(FocalShareOf, IsAsSureAsItIsRight) {
  double sum = 0.0;
  int told = 0;
  constexpr int many = 200;
  for (std::uint64_t seed = 0; seed < many; ++seed) {
    Random random(1000 + seed);
    const Passage passage{
        .truly_m = random.normal(0.0, 0.1), .focal_share = random.normal(0.0, kSaidTo), .seed = seed};
    const auto found = measured(views(passage));
    if (!found) continue;
    sum += std::pow(found->share - passage.focal_share, 2) / found->variance;
    ++told;
  }
  ASSERT_GE(told, 9 * many / 10);
  EXPECT_NEAR(sum / told, 1.0, 0.35);
}

/// Tests that what is held beforehand is not in what is told, or it would count with each look.
TEST(FocalShareOf, LooksThatTellLittleAreRightOnAverage) {
  constexpr double share = 0.02;
  double sum = 0.0;
  double weights = 0.0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const auto found = measured(views({.focal_share = share, .nearest_m = 3.0, .furthest_m = 7.0, .seed = seed}));
    if (!found) continue;
    sum += found->share / found->variance;
    weights += 1.0 / found->variance;
  }
  ASSERT_GT(weights, 0.0);
  EXPECT_NEAR(sum / weights, share, 0.0025);
}

TEST(FocalShareOf, WrongMatchesHardlyCount) {
  const auto found = measured(views({.truly_m = 0.1, .focal_share = 0.02, .wrong = 0.2, .seed = 5}));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->share, 0.02, 0.008);
}

TEST(FocalShareOf, WhereAllStandsAtOneDistanceItIsNotTold) {
  const auto near = measured(views({.nearest_m = 3.9, .furthest_m = 4.1, .seed = 6}));
  EXPECT_TRUE(!near || std::sqrt(near->variance) > 0.5 * kSaidTo) << "a step ahead would look the same";
}

TEST(FocalShareOf, HardlyAnythingTellsNothing) {
  PassageViews few = views({});
  for (auto& same : few.same) same.resize(2);
  EXPECT_FALSE(measured(few));
}

}  // namespace
}  // namespace weft::agents
