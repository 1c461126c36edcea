#include "agents/methods/along_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "agents/methods/advance.hpp"
#include "core/random.hpp"

namespace weft::agents {
namespace {

constexpr double kShare = 0.06;     // one sigma of the wheels' scale, as stated
constexpr double kTurnRadM = 0.08;  // and of what they turn unnoticed

/// Returns a step as wheels tell of 5 cm.
Step told() {
  Step step;
  step.seen = true;
  constexpr double metres = 0.05;
  step.common(0, 0) = kShare * metres;
  step.common(kYaw, 1) = kTurnRadM * metres;
  step.previous_from_current = AlongPath{metres, std::pow(kShare * metres, 2) + 4e-4 * metres, 0.0,
                                         std::pow(kTurnRadM * metres, 2) + 9e-4 * metres};
  return step;
}

/// Simulates a robot that really drives further than its wheels say, and turns; fixes come every other step.
struct Drive {
  double scale = 1.1;
  double turn_rad_m = -0.1;
  AlongErrors errors;
  Relation start_from_robot = AlongPath{};
  CommonErrors common = CommonErrors::Zero();
  AlongPath truly;
  Random random{4};

  const AlongPath& believed() const { return std::get<AlongPath>(start_from_robot); }
  void drive() {
    start_from_robot = advanced(start_from_robot, errors.improved(told()), common);
    truly.distance_m += scale * 0.05;
    truly.heading_shift_rad += turn_rad_m * 0.05;
  }
  void fix() {
    const AlongPath seen{truly.distance_m + random.normal(0.0, 0.02), 4e-4,
                         truly.heading_shift_rad + random.normal(0.0, 0.01), 1e-4};
    const AlongPath predicted = believed();
    const auto weighed = [](double a, double va, double b, double vb) { return a + va / (va + vb) * (b - a); };
    const auto left = [](double va, double vb) { return va * vb / (va + vb); };
    start_from_robot = AlongPath{
        weighed(predicted.distance_m, predicted.distance_variance_m2, seen.distance_m, seen.distance_variance_m2),
        left(predicted.distance_variance_m2, seen.distance_variance_m2),
        weighed(predicted.heading_shift_rad, predicted.heading_variance_rad2, seen.heading_shift_rad,
                seen.heading_variance_rad2),
        left(predicted.heading_variance_rad2, seen.heading_variance_rad2)};
    errors.learn(predicted, seen, common);
  }
};

TEST(AlongErrors, FixesShowWhatTheWheelsGetWrong) {
  Drive drive;
  for (int i = 0; i < 400; ++i) {
    drive.drive();
    if (i % 2 == 1) drive.fix();
  }
  EXPECT_NEAR(1.0 + kShare * drive.errors.distance_error(), drive.scale, 0.01);
  EXPECT_NEAR(kTurnRadM * drive.errors.turn_error(), drive.turn_rad_m, 0.01);
}

TEST(AlongErrors, OnAStraightWithoutFixesItThenErrsLess) {
  Drive drive;
  for (int i = 0; i < 400; ++i) {
    drive.drive();
    if (i % 2 == 1) drive.fix();
  }
  const double before_m = drive.truly.distance_m - drive.believed().distance_m;
  for (int i = 0; i < 100; ++i) drive.drive();
  const double after_m = drive.truly.distance_m - drive.believed().distance_m;
  EXPECT_LT(std::abs(after_m - before_m), 0.05) << "of 5.5 m; the wheels alone are 0.5 m off";
  EXPECT_LT(drive.believed().distance_variance_m2, std::pow(kShare * 5.0, 2)) << "and knows it";
  EXPECT_GT(std::sqrt(drive.believed().distance_variance_m2), std::abs(after_m) / 3.0);
}

TEST(AlongErrors, WrongFixesDoNotMakeWheelsWhatNoneAre) {
  AlongErrors errors;
  CommonErrors common = CommonErrors::Zero();
  common(0, 0) = common(kYaw, 1) = 0.1;
  errors.learn({0.0, 0.01, 0.0, 0.01}, {1e3, 1e-4, 3.0, 1e-4}, common);
  EXPECT_LE(errors.distance_error(), 5.0);
  EXPECT_LE(errors.turn_error(), 5.0);
}

TEST(AlongErrors, WithoutFixesNothingIsLearnt) {
  const Step step = told();
  const Step same = AlongErrors{}.improved(step);
  EXPECT_TRUE(identical(same.previous_from_current, step.previous_from_current));
  EXPECT_EQ(same.common, step.common);
}

TEST(AlongErrors, PosesAreLeftAlone) {
  Drive drive;
  drive.drive();
  drive.fix();
  Step metric = told();
  metric.previous_from_current = Metric2{{0.05, 0.0, 0.0}, 1e-6 * Eigen::Matrix3d::Identity()};
  EXPECT_TRUE(identical(drive.errors.improved(metric).previous_from_current, metric.previous_from_current));
}

}  // namespace
}  // namespace weft::agents
