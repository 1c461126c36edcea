#include "agents/bodies/sim/base.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "sites.hpp"

namespace weft::agents::sim {
namespace {

Base base_of(const Site& site, const WheelErrors& wheels = {}) {
  return Base(site.base, site.disturbances, Solids(site), wheels, site.robots[0].site_from_robot, Random(1));
}

Site calm_site() {
  Site site = empty_site();
  site.disturbances = no_disturbances();
  return site;
}

TEST(Base, CommandsTakeEffectAfterTheirDelay) {
  const Site site = calm_site();
  Base base = base_of(site);
  base.advance({0.5, 0.0}, site.base.command_delay_s - 0.005);
  EXPECT_EQ(base.velocity().linear_m_s, 0.0);
  EXPECT_FALSE(base.at_rest());
  base.advance({0.5, 0.0}, 0.05);
  EXPECT_GT(base.velocity().linear_m_s, 0.0);
}

TEST(Base, SpeedsUpNoFasterThanItsLimit) {
  const Site site = calm_site();
  Base base = base_of(site);
  base.advance({0.5, 0.0}, site.base.command_delay_s);
  double before = base.velocity().linear_m_s;
  for (int i = 0; i < 100; ++i) {
    base.advance({0.5, 0.0}, 0.01);
    EXPECT_LE(base.velocity().linear_m_s - before, site.base.acceleration_m_s2 * 0.01 + 1e-9);
    before = base.velocity().linear_m_s;
  }
  EXPECT_NEAR(before, 0.5, 0.01);
}

TEST(Base, DrivesTheCommandedArc) {
  const Site site = calm_site();
  Base base = base_of(site);
  base.advance({0.4, 0.4}, 3.0);
  const Pose2 before = base.site_from_robot();
  base.advance({0.4, 0.4}, 2.0);
  const Pose2 moved = before.inverse() * base.site_from_robot();
  const Pose2 expected = se2_exp(Eigen::Vector3d(0.8, 0.0, 0.8));
  EXPECT_NEAR(moved.x, expected.x, 1e-3);
  EXPECT_NEAR(moved.y, expected.y, 1e-3);
  EXPECT_NEAR(moved.heading, expected.heading, 1e-3);
}

TEST(Base, ComesToRest) {
  const Site site = calm_site();
  Base base = base_of(site);
  base.advance({0.6, 0.2}, 2.0);
  base.advance({}, 2.0);
  EXPECT_TRUE(base.at_rest());
  const Pose2 before = base.site_from_robot();
  base.advance({}, 5.0);
  EXPECT_EQ(base.site_from_robot(), before);
}

TEST(Base, StopsAtARack) {
  Site site = calm_site();
  site.boxes.push_back({Box::Kind::rack, "rack", {7.0, 6.0, 0.0}, 2.0, 2.0, 3.0});
  Base base = base_of(site);
  base.advance({0.5, 0.0}, 20.0);
  EXPECT_NEAR(base.site_from_robot().x, 6.0 - site.base.radius_m, 0.01);
  base.advance({-0.5, 0.0}, 3.0);
  EXPECT_LT(base.site_from_robot().x, 5.5);
}

TEST(Base, WheelsReportTheStatedErrors) {
  const Site site = calm_site();
  const WheelErrors wheels{1.02, 1.04};
  Base base = base_of(site, wheels);
  base.advance({0.5, 0.0}, 10.0);
  const double driven = base.site_from_robot().x - site.robots[0].site_from_robot.x;
  const WheelStep step = base.take_wheel_step();
  EXPECT_NEAR(step.distance_m / driven, 1.03, 1e-6);
  EXPECT_NEAR(step.heading_rad, 0.02 * driven / site.base.track_m, 1e-6);
  EXPECT_EQ(base.take_wheel_step().distance_m, 0.0);
}

TEST(WheelErrors, AreAtLeastAsStatedAndDiffer) {
  const Disturbances d;
  std::vector<WheelErrors> drawn;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const WheelErrors e = wheel_errors_from(d, Random(seed));
    const double scale = std::abs((e.left_scale + e.right_scale) / 2 - 1.0);
    const double asymmetry = std::abs(e.right_scale - e.left_scale) / ((e.left_scale + e.right_scale) / 2);
    EXPECT_GE(scale, 0.03 - 1e-9);
    EXPECT_LE(scale, 0.036 + 1e-9);
    EXPECT_GE(asymmetry, 0.02 - 1e-9);
    EXPECT_LE(asymmetry, 0.024 + 1e-9);
    for (const WheelErrors& other : drawn) {
      EXPECT_NE(other.left_scale, e.left_scale);
    }
    drawn.push_back(e);
  }
}

TEST(Base, SlipMakesTheWayDifferFromTheRolledOne) {
  Site site = calm_site();
  site.disturbances.slip = 0.01;
  Base base = base_of(site);
  base.advance({0.5, 0.0}, 20.0);
  const Pose2 moved = site.robots[0].site_from_robot.inverse() * base.site_from_robot();
  EXPECT_GT(std::abs(moved.heading), 1e-4);
  EXPECT_LT(std::abs(moved.heading), 0.3);
}

}  // namespace
}  // namespace weft::agents::sim
