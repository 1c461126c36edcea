#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "core/geometry/pose3.hpp"
#include "core/random.hpp"

namespace weft {
namespace {

constexpr double kPi = std::numbers::pi;

bool is_near(const Pose2& a, const Pose2& b, double tolerance = 1e-9) {
  return (a.translation() - b.translation()).norm() < tolerance &&
         std::abs(wrap_angle(a.heading - b.heading)) < tolerance;
}

bool is_near(const Pose3& a, const Pose3& b, double tolerance = 1e-9) {
  return (a.translation - b.translation).norm() < tolerance &&
         (a.rotation.toRotationMatrix() - b.rotation.toRotationMatrix()).norm() < tolerance;
}

const std::vector<Pose2> kAwkward2{
    {},
    {1.0, 2.0, 0.0},
    {-3.0, 0.5, kPi},
    {0.1, -0.2, -kPi + 1e-12},
    {0.0, 0.0, kPi - 1e-7},
    {5.0, 4.0, 1e-7},
    {5.0, 4.0, -1e-12},
    {1e4, -1e4, 0.5 * kPi},
    {0.3, 0.7, -2.2},
};

std::vector<Pose3> awkward3() {
  const std::vector<Eigen::Vector3d> turns{{0.0, 0.0, 0.0},  {1e-9, 0.0, 0.0},        {0.0, 1e-4, -1e-4},
                                           {0.3, -0.2, 0.9}, {kPi, 0.0, 0.0},         {0.0, kPi - 1e-7, 0.0},
                                           {1.8, 1.8, -1.8}, {0.0, 0.0, -kPi + 1e-3}, {2e-3, 1e-3, 0.0}};
  std::vector<Pose3> poses;
  for (const Eigen::Vector3d& turn : turns) {
    for (const Eigen::Vector3d& shift : {Eigen::Vector3d(0.0, 0.0, 0.0), Eigen::Vector3d(1.0, -2.0, 30.0)}) {
      Vector6d twist;
      twist << shift, turn;
      poses.push_back(se3_exp(twist));
    }
  }
  return poses;
}

const std::vector<Pose3> kAwkward3 = awkward3();

TEST(Angle, WrapsIntoTheHalfOpenInterval) {
  EXPECT_DOUBLE_EQ(wrap_angle(-kPi), kPi);
  EXPECT_DOUBLE_EQ(wrap_angle(kPi), kPi);
  EXPECT_DOUBLE_EQ(wrap_angle(3.0 * kPi), kPi);
  EXPECT_NEAR(wrap_angle(2.0 * kPi + 0.25), 0.25, 1e-12);
  EXPECT_NEAR(wrap_angle(-2.0 * kPi - 0.25), -0.25, 1e-12);
}

template <class Poses>
void expect_group(const Poses& poses, double tolerance) {
  using Pose = typename Poses::value_type;
  for (const Pose& a : poses) {
    EXPECT_TRUE(is_near(a * a.inverse(), Pose{}, tolerance));
    EXPECT_TRUE(is_near(a.inverse() * a, Pose{}, tolerance));
    EXPECT_TRUE(is_near(a * Pose{}, a, tolerance));
    EXPECT_TRUE(is_near(Pose{} * a, a, tolerance));
    EXPECT_TRUE(is_near(a.inverse().inverse(), a, tolerance));
    for (const Pose& b : poses) {
      EXPECT_TRUE(is_near((a * b).inverse(), b.inverse() * a.inverse(), tolerance));
      for (const Pose& c : poses) EXPECT_TRUE(is_near((a * b) * c, a * (b * c), tolerance));
    }
  }
}

TEST(Angle, WrapsAsTheRemainderDoesToTheLastBit) {
  Random random(3);
  for (int i = 0; i < 100'000; ++i) {
    const double angle = random.uniform(-5.0 * kPi, 5.0 * kPi);
    EXPECT_EQ(wrap_angle(angle), std::remainder(angle, 2.0 * kPi)) << angle;
  }
}

TEST(Pose2, IsAGroup) {
  expect_group(kAwkward2, 1e-7);
}  // 1e4 m times rounding of angles
TEST(Pose3, IsAGroup) {
  expect_group(kAwkward3, 1e-9);
}

TEST(Pose2, ActsOnPoints) {
  const Eigen::Vector2d point{0.4, -1.1};
  EXPECT_TRUE((Pose2{1.0, 2.0, 0.5 * kPi} * Eigen::Vector2d(1.0, 0.0)).isApprox(Eigen::Vector2d(1.0, 3.0)));
  for (const Pose2& a : kAwkward2) {
    for (const Pose2& b : kAwkward2) EXPECT_LT(((a * b) * point - a * (b * point)).norm(), 1e-7);
  }
}

TEST(Pose2, ExpAndLogUndoEachOther) {
  for (const Pose2& a : kAwkward2) EXPECT_TRUE(is_near(se2_exp(se2_log(a)), a, 1e-7));
  for (const double omega : {0.0, 1e-12, 1e-9, 1e-6, -1e-5, 0.3, -3.0, 3.14}) {
    const Eigen::Vector3d twist{0.7, -1.3, omega};
    EXPECT_LT((se2_log(se2_exp(twist)) - twist).norm(), 1e-9) << omega;
  }
}

TEST(Pose3, ExpAndLogUndoEachOther) {
  for (const Pose3& a : kAwkward3) EXPECT_TRUE(is_near(se3_exp(se3_log(a)), a, 1e-8));
  for (const double angle : {0.0, 1e-12, 1e-9, 1e-5, 9.99e-4, 1.01e-3, 0.3, 2.0, 3.14}) {
    Vector6d twist;
    twist << 0.7, -1.3, 0.2, angle * Eigen::Vector3d(1.0, -2.0, 2.0) / 3.0;
    EXPECT_LT((se3_log(se3_exp(twist)) - twist).norm(), 1e-9) << angle;
  }
}

TEST(Pose3, ExpFollowsAConstantTwistInSmallSteps) {
  Vector6d twist;
  twist << 1.0, 0.2, -0.3, 0.4, -0.9, 1.1;
  Pose3 walked;
  for (int i = 0; i < 1000; ++i) walked = walked * se3_exp(twist / 1000.0);
  EXPECT_TRUE(is_near(walked, se3_exp(twist), 1e-9));
}

TEST(Pose2, AdjointMovesATwistToTheOtherSide) {
  const Eigen::Vector3d xi{0.01, -0.02, 0.03};
  for (const Pose2& a : kAwkward2) {
    if (std::abs(a.x) > 100.0) continue;  // rounding of metres swamps the law
    EXPECT_TRUE(is_near(a * se2_exp(xi), se2_exp(adjoint(a) * xi) * a));
  }
}

TEST(Pose3, AdjointMovesATwistToTheOtherSide) {
  Vector6d xi;
  xi << 0.01, -0.02, 0.03, 0.02, 0.01, -0.015;
  for (const Pose3& a : kAwkward3) EXPECT_TRUE(is_near(a * se3_exp(xi), se3_exp(adjoint(a) * xi) * a));
}

TEST(Pose3, LiftIsAHomomorphismAndProjectUndoesIt) {
  for (const Pose2& a : kAwkward2) {
    EXPECT_TRUE(is_near(project(lift(a)), a));
    for (const Pose2& b : kAwkward2) EXPECT_TRUE(is_near(lift(a) * lift(b), lift(a * b), 1e-7));
  }
}

TEST(Poses, NotFiniteIsSeen) {
  EXPECT_FALSE(is_finite(Pose2{0.0, NAN, 0.0}));
  EXPECT_FALSE(is_finite(Pose2{0.0, 0.0, INFINITY}));
  EXPECT_TRUE(is_finite(Pose2{}));
  Pose3 pose;
  EXPECT_TRUE(is_finite(pose));
  pose.translation.z() = NAN;
  EXPECT_FALSE(is_finite(pose));
  pose = {};
  pose.rotation.w() = NAN;
  EXPECT_FALSE(is_finite(pose));
}

}  // namespace
}  // namespace weft
