#include "clients/evaluate/particles/odometry.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::evaluate::particles {
namespace {

std::vector<LaserScan> straight_on(int count, double step_m) {
  std::vector<LaserScan> scans(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) scans[static_cast<std::size_t>(i)].map_from_laser = {step_m * i, 0.0, 0.0};
  return scans;
}

TEST(SimulatedOdometry, IsOffByItsBiasAndNoise) {
  const std::vector<LaserScan> scans = straight_on(4001, 0.1);
  const OdometryErrors errors;
  const std::vector<Pose2> steps = simulated_odometry(scans, errors, 3);
  ASSERT_EQ(steps.size(), scans.size());
  EXPECT_EQ(steps[0], Pose2{});
  double sum = 0.0;
  double squares = 0.0;
  double turns = 0.0;
  for (std::size_t i = 1; i < steps.size(); ++i) {
    sum += steps[i].x;
    squares += steps[i].x * steps[i].x;
    turns += steps[i].heading * steps[i].heading;
  }
  const double mean = sum / 4000.0;
  EXPECT_NEAR(std::abs(mean / 0.1 - 1.0), errors.scale_bias, 0.003);
  EXPECT_NEAR(std::sqrt(squares / 4000.0 - mean * mean), 0.1 * errors.noise, 0.0004);
  EXPECT_NEAR(std::sqrt(turns / 4000.0), errors.heading_rad_m05 * std::sqrt(0.1), 0.0004);
}

TEST(SimulatedOdometry, IsAnotherForAnotherSeedAndTheSameForTheSame) {
  const std::vector<LaserScan> scans = straight_on(20, 0.3);
  EXPECT_EQ(simulated_odometry(scans, {}, 1)[7], simulated_odometry(scans, {}, 1)[7]);
  EXPECT_NE(simulated_odometry(scans, {}, 1)[7], simulated_odometry(scans, {}, 2)[7]);
  EXPECT_EQ(simulated_odometry(scans, {0.0, 0.0, 0.0}, 1)[7].x,
            scans[7].map_from_laser.x - scans[6].map_from_laser.x);
}

TEST(AmclMotion, IsAsUncertainAsItsAlphasSay) {
  const agents::UncertainMotion straight = motion_of({0.5, 0.0, 0.0}, 0.2);
  EXPECT_NEAR(straight.covariance(0, 0), 0.2 * 0.25, 1e-12) << "along";
  EXPECT_NEAR(straight.covariance(1, 1), 0.25 * 0.2 * 0.25, 1e-12) << "aside: the way times the first turn's";
  EXPECT_NEAR(straight.covariance(2, 2), 2.0 * 0.2 * 0.25, 1e-12);
  const agents::UncertainMotion turn = motion_of({0.0, 0.0, 0.4}, 0.2);
  EXPECT_NEAR(turn.covariance(2, 2), 0.2 * 0.16, 1e-12);
  EXPECT_NEAR(turn.covariance(1, 1), 0.0, 1e-2);
}

TEST(AmclMotion, DrivingBackwardsIsNoTurn) {
  const agents::UncertainMotion back = motion_of({-0.5, 0.0, 0.0}, 0.2);
  EXPECT_NEAR(back.covariance(2, 2), motion_of({0.5, 0.0, 0.0}, 0.2).covariance(2, 2), 1e-12);
}

TEST(AmclMotion, ErrorsAreInTheFrameOfTheEnd) {
  // Straight on, then a quarter turn left: an error along the way lies aside of the end.
  const agents::UncertainMotion motion = motion_of({1.0, 0.0, 1.5707963}, 0.2);
  EXPECT_GT(motion.covariance(1, 1), 0.2);
  EXPECT_GT(motion.covariance(0, 0), 0.2 - 1e-9);
  EXPECT_NEAR(motion.covariance(0, 1), 0.0, 1e-6);
}

}  // namespace
}  // namespace weft::evaluate::particles
