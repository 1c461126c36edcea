#include "agents/control/steering.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::agents {
namespace {

TEST(Steering, TurnsTowardsThePathFromBothSides) {
  const SteeringConfig config;
  EXPECT_LT(steer_rate(config, {0.2, 0.0}, 0.0, 0.5), 0.0);  // left of the path: turn right
  EXPECT_GT(steer_rate(config, {-0.2, 0.0}, 0.0, 0.5), 0.0);
  EXPECT_LT(steer_rate(config, {0.0, 0.2}, 0.0, 0.5), 0.0);
  EXPECT_DOUBLE_EQ(steer_rate(config, {0.0, 0.0}, 0.0, 0.5), 0.0);
}

TEST(Steering, OnABendItTurnsWithThePath) {
  EXPECT_NEAR(steer_rate(SteeringConfig{}, {0.0, 0.0}, 0.8, 0.5), 0.4, 1e-12);
}

TEST(Steering, FarOffItApproachesNoSteeperThanAllowed) {
  const SteeringConfig config;
  EXPECT_NEAR(steer_rate(config, {50.0, -config.max_approach_rad}, 0.0, 0.5), 0.0, 1e-12);
}

TEST(Steering, RateIsLimited) {
  const SteeringConfig config;
  EXPECT_DOUBLE_EQ(steer_rate(config, {0.0, 2.0}, 0.0, 0.5), -config.max_angular_rad_s);
}

TEST(Steering, ErrorsAreSeenFromThePath) {
  const TrackError error = track_error({1.0, 1.0, M_PI / 2}, {0.8, 1.0, M_PI / 2 + 0.1});
  EXPECT_NEAR(error.cross_track_m, 0.2, 1e-12);  // the path runs along y: smaller x is left of it
  EXPECT_NEAR(error.heading_rad, 0.1, 1e-12);
}

}  // namespace
}  // namespace weft::agents
