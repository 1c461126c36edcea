#include "core/random.hpp"

#include <gtest/gtest.h>

#include <array>

namespace weft {
namespace {

TEST(Random, RepeatsOnEveryMachine) {
  Random random(42);
  for (const std::uint64_t expected : std::array<std::uint64_t, 4>{15021278609987233951U, 5881210131331364753U,
                                                                   18149643915985481100U, 12933668939759105464U})
    EXPECT_EQ(random.next(), expected);
  EXPECT_EQ(Random(42).fork(3).next(), 15283472594345512966U);
}

TEST(Random, SeedsAndForksDiffer) {
  EXPECT_NE(Random(0).next(), Random(1).next());
  Random parent(5);
  Random copy = parent;
  EXPECT_EQ(copy.next(), parent.next());
  Random same = parent;
  EXPECT_NE(parent.fork(1).next(), same.fork(2).next());
  EXPECT_NE(Random(5).fork(0).next(), Random(5).next());
}

TEST(Random, UniformAndNormalHaveTheirMoments) {
  Random random(1);
  constexpr int kDraws = 200'000;
  double sum = 0.0, squares = 0.0, normals = 0.0, normal_squares = 0.0, fourth = 0.0;
  int hits = 0;
  for (int i = 0; i < kDraws; ++i) {
    const double u = random.uniform();
    ASSERT_TRUE(u >= 0.0 && u < 1.0);
    sum += u;
    squares += u * u;
    const double n = random.normal();
    normals += n;
    normal_squares += n * n;
    fourth += n * n * n * n;
    if (random.chance(0.25)) ++hits;
  }
  EXPECT_NEAR(sum / kDraws, 0.5, 0.003);
  EXPECT_NEAR(squares / kDraws, 1.0 / 3.0, 0.003);
  EXPECT_NEAR(normals / kDraws, 0.0, 0.01);
  EXPECT_NEAR(normal_squares / kDraws, 1.0, 0.015);
  EXPECT_NEAR(fourth / kDraws, 3.0, 0.15);
  EXPECT_NEAR(static_cast<double>(hits) / kDraws, 0.25, 0.005);
}

TEST(Random, StaysInItsBounds) {
  Random random(2);
  std::array<int, 7> seen{};
  for (int i = 0; i < 7000; ++i) ++seen.at(random.below(7));
  for (const int count : seen) EXPECT_NEAR(count, 1000, 150);
  for (int i = 0; i < 1000; ++i) {
    const double value = random.uniform(-2.0, 5.0);
    EXPECT_TRUE(value >= -2.0 && value < 5.0);
  }
}

}  // namespace
}  // namespace weft
