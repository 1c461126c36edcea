#include "agents/bodies/sim/stance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace weft::agents::sim {
namespace {

constexpr double kUnevenM = 0.005;

/// Returns how far the floor lies above the plane that a body stands on, at a place in its frame.
double gap(const Relief& relief, const Pose3& site_from_body, double forward_m, double left_m) {
  const Eigen::Vector3d p = site_from_body * Eigen::Vector3d(forward_m, left_m, 0.0);
  return relief.height_m(p.x(), p.y()) - p.z();
}

TEST(Stance, FitsTheFloorUnderWheelsAndEnds) {
  const Relief relief(kUnevenM, 4);
  const BaseSetup base;
  for (int i = 0; i < 200; ++i) {
    const Pose3 body = stance_on(relief, base, {0.37 * i, 0.11 * i, 0.7 * i});
    const double before = gap(relief, body, base.radius_m, 0.0);
    const double behind = gap(relief, body, -base.radius_m, 0.0);
    const double left = gap(relief, body, 0.0, base.track_m / 2);
    const double right = gap(relief, body, 0.0, -base.track_m / 2);
    // A body does not bend: what is left is what no plane fits.
    EXPECT_NEAR(before, behind, 2e-5);
    EXPECT_NEAR(left, right, 2e-5);
    EXPECT_NEAR(before + behind, -(left + right), 4e-5);
  }
}

TEST(Stance, TiltsByTheSlopeOfTheFloor) {
  const Relief relief(kUnevenM, 4);
  BaseSetup tiny;
  tiny.radius_m = tiny.track_m = 0.02;  // as the slope at one point
  double steepest = 0.0;
  for (int i = 0; i < 200; ++i) {
    const Pose2 plan{0.37 * i, 0.11 * i, 0.7 * i};
    const Pose3 body = stance_on(relief, tiny, plan);
    const auto slope = [&](double forward_m, double left_m) {
      const Eigen::Vector2d to = plan * Eigen::Vector2d(forward_m, left_m);
      const Eigen::Vector2d from = plan * Eigen::Vector2d(-forward_m, -left_m);
      return (relief.height_m(to.x(), to.y()) - relief.height_m(from.x(), from.y())) / 2e-4;
    };
    const Eigen::Vector3d ahead = body.rotation * Eigen::Vector3d::UnitX();
    const Eigen::Vector3d aside = body.rotation * Eigen::Vector3d::UnitY();
    EXPECT_NEAR(std::asin(ahead.z()), std::atan(slope(1e-4, 0.0)), 1e-3);
    EXPECT_NEAR(std::asin(aside.z()), std::atan(slope(0.0, 1e-4)), 1e-3);
    EXPECT_NEAR(std::remainder(std::atan2(ahead.y(), ahead.x()) - plan.heading, 2 * M_PI), 0.0, 1e-3);
    EXPECT_EQ(body.translation.head<2>(), Eigen::Vector2d(plan.x, plan.y));
    steepest = std::max(steepest, std::abs(ahead.z()));
  }
  EXPECT_GT(steepest, 0.01) << "a floor uneven by 5 mm tilts it by half a degree and more";
}

TEST(Stance, OnAPlaneIsThePlan) {
  const Pose2 plan{3.0, -2.0, 1.1};
  const Pose3 body = stance_on(Relief(0.0, 1), {}, plan);
  EXPECT_EQ(body.translation, lift(plan).translation);
  EXPECT_NEAR(body.rotation.angularDistance(lift(plan).rotation), 0.0, 1e-12);
}

}  // namespace
}  // namespace weft::agents::sim
