#include "agents/control/speed.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::agents {
namespace {

Spline straight(double length_m) {
  return Spline::through({{0, 0, 0}, {length_m, 0, 0}}).value();
}

TEST(SpeedAt, ReachesTheEndAtRest) {
  const SpeedConfig config;
  const Spline path = straight(3.0);
  EXPECT_DOUBLE_EQ(speed_at(config, path, 0.0, {}, 0.6), 0.6);
  double before = 0.6;
  for (double along = 2.0; along < 3.0; along += 0.01) {
    const double speed = speed_at(config, path, along, {}, 0.6);
    EXPECT_LE(speed, before + 1e-12);
    EXPECT_LE(speed * speed, 2.0 * config.deceleration_m_s2 * (3.0 - along) + 1e-9) << along;
    EXPECT_GT(speed, 0.0);
    before = speed;
  }
  EXPECT_DOUBLE_EQ(speed_at(config, path, 3.0, {}, 0.6), 0.0);
  EXPECT_DOUBLE_EQ(speed_at(config, path, 3.1, {}, 0.6), 0.0);
}

TEST(SpeedAt, IsLowerInABendAndBeforeIt) {
  const SpeedConfig config;
  std::vector<Pose2> poses{{-2, 0, 0}, {-1, 0, 0}};
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.13 * i;
    poses.push_back({0.5 * std::sin(angle), 0.5 * (1.0 - std::cos(angle)), angle});
  }
  const Spline path = Spline::through(poses).value();
  const double in_bend = speed_at(config, path, path.along_of(6), {}, 0.6);
  EXPECT_NEAR(in_bend, std::sqrt(config.lateral_acceleration_m_s2 * 0.5), 0.05);
  EXPECT_LT(speed_at(config, path, path.along_of(2) - 0.15, {}, 0.6), 0.58);
}

TEST(SpeedAt, ErrorsSlowButNeverStop) {
  const SpeedConfig config;
  const Spline path = straight(5.0);
  EXPECT_NEAR(speed_at(config, path, 0.0, {config.cross_track_halves_m, 0.0}, 0.6), 0.3, 1e-9);
  EXPECT_NEAR(speed_at(config, path, 0.0, {3.0, 1.5}, 0.6), config.slowest_m_s, 1e-9);
}

TEST(SpeedControl, BeginsWithTheSpeedOfTheBase) {
  const SpeedConfig config;
  SpeedControl control;
  EXPECT_NEAR(control.update(config, 0.6, 0.5, 0.1), 0.5 + config.acceleration_m_s2 * 0.1, 0.05)
      << "who takes over a rolling robot does not stop it first";
}

TEST(SpeedControl, AccelerationIsLimitedAndBrakingIsNot) {
  const SpeedConfig config;
  SpeedControl control;
  double measured = 0.0;
  for (int i = 0; i < 10; ++i) {
    const double command = control.update(config, 0.6, measured, 0.1);
    EXPECT_LE(command, config.acceleration_m_s2 * 0.1 * (i + 1) + 0.1);
    measured = command;
  }
  EXPECT_DOUBLE_EQ(control.update(config, 0.0, measured, 0.1), 0.0);
}

TEST(SpeedControl, MakesUpForABaseThatIsTooSlow) {
  const SpeedConfig config;
  SpeedControl control;
  double measured = 0.0;
  for (int i = 0; i < 200; ++i) measured += 0.5 * (0.93 * control.update(config, 0.4, measured, 0.05) - measured);
  EXPECT_NEAR(measured, 0.4, 0.005);
}

}  // namespace
}  // namespace weft::agents
