#include "agents/navigation/speed_limit.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::agents {
namespace {

Estimate believed(double blind_m, double sigma_m) {
  Metric2 relation{{0.1, 0.02, 0.3}, Eigen::Matrix3d::Zero()};
  relation.covariance.diagonal() << 0.25 * sigma_m * sigma_m, sigma_m * sigma_m, 1e-4;
  return {PlaceId{{1}, 0}, relation, blind_m};
}

TEST(SpeedLimit, IsTheSpeedThatWasAskedForWhileItSeesItsPlaces) {
  const FollowConfig config;
  EXPECT_DOUBLE_EQ(speed_limit(config, believed(0.0, 0.01)), config.speed_m_s);
  EXPECT_DOUBLE_EQ(speed_limit(config, believed(0.9 * config.sure_m, config.sure_sigma_m)), config.speed_m_s);
}

TEST(SpeedLimit, FallsTheLongerThereIsNoFixAndNotToNothing) {
  const FollowConfig config;
  double before = config.speed_m_s;
  for (double blind_m = config.sure_m + 0.1; blind_m < config.blind_limit_m; blind_m += 0.2) {
    const double now = speed_limit(config, believed(blind_m, 0.01));
    EXPECT_LT(now, before) << blind_m;
    before = std::max(now, config.unsure_share * config.speed_m_s + 1e-9);
  }
  EXPECT_DOUBLE_EQ(speed_limit(config, believed(config.blind_limit_m, 0.01)), config.unsure_share * config.speed_m_s);
}

TEST(SpeedLimit, FallsWithTheSigmaAcrossItsWay) {
  const FollowConfig config;
  EXPECT_DOUBLE_EQ(speed_limit(config, believed(0.0, 2.0 * config.sure_sigma_m)), 0.5 * config.speed_m_s);
  EXPECT_DOUBLE_EQ(speed_limit(config, believed(0.0, 100.0 * config.sure_sigma_m)),
                   config.unsure_share * config.speed_m_s);
}

TEST(SpeedLimit, ARelationAlongAPathCountsTheDistanceAlone) {
  const FollowConfig config;
  const double sigma_m = 2.0 * config.sure_sigma_m;
  const Estimate along{PlaceId{{1}, 0}, AlongPath{0.1, sigma_m * sigma_m, 0.0, 1e-4}, 0.0};
  EXPECT_NEAR(speed_limit(config, along), 0.5 * config.speed_m_s, 1e-9);
}

}  // namespace
}  // namespace weft::agents
