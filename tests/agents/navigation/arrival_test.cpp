#include "agents/navigation/arrival.hpp"

#include <gtest/gtest.h>

/// Tests the last centimetres: moves end, whatever the estimates of the goal do.
namespace weft::agents::test {
namespace {

constexpr int kMostSamples = 20'000;

/// Steps an arrival that begins now, with what `sees` says of the goal at each sample, until it arrives or gives up.
template <class Sees>
Arrival::Out arrived(const Sees& sees, int& samples) {
  Arrival arrival;
  arrival.begin();
  Arrival::Out out;
  for (samples = 0; samples < kMostSamples && !out.arrived && out.reason.empty(); ++samples) {
    out = arrival.step(FollowConfig{}, TrackerConfig{}, sees(samples), true);
  }
  return out;
}

TEST(Arrival, CreepsToAGoalAheadAndStands) {
  double left = 0.08;
  int samples = 0;
  Arrival arrival;
  arrival.begin();
  Arrival::Out out;
  for (; samples < kMostSamples && !out.arrived; ++samples) {
    out = arrival.step(FollowConfig{}, TrackerConfig{}, {left, 0.0, 0.0}, true);
    left -= out.command.linear_m_s * 0.05;
  }
  EXPECT_TRUE(out.arrived);
  EXPECT_LT(std::abs(left), 0.01);
}

TEST(Arrival, EndsWhereTheGoalJumpsFromAheadToBehind) {
  int samples = 0;
  const Arrival::Out out = arrived(
      [](int sample) {
        return Pose2{sample % 10 == 0 ? 0.05 : (sample % 2 == 0 ? 0.02 : -0.02), 0.0, 0.0};
      },
      samples);
  EXPECT_TRUE(out.arrived || out.reason == "goal_not_reached") << samples;
}

TEST(Arrival, EndsWhereTheHeadingJumps) {
  int samples = 0;
  const Arrival::Out out = arrived([](int sample) { return Pose2{0.0, 0.0, sample % 2 == 0 ? 0.3 : -0.3}; }, samples);
  EXPECT_EQ(out.reason, "goal_not_reached") << samples;
}

TEST(Arrival, EndsWhereTheGoalJumpsFromSideToSide) {
  Arrival arrival;
  arrival.begin();
  Arrival::Out out;
  double ahead = 0.05;
  int samples = 0;
  for (; samples < kMostSamples && !out.arrived && out.reason.empty(); ++samples) {
    out = arrival.step(FollowConfig{}, TrackerConfig{}, {ahead, samples % 2 == 0 ? 0.06 : -0.06, 0.0}, true);
    ahead -= out.command.linear_m_s * 0.05;
  }
  EXPECT_EQ(out.reason, "goal_not_reached") << samples;
}

}  // namespace
}  // namespace weft::agents::test
