#include "agents/perception/homography.hpp"
#include "agents/perception/plane/geometry.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "core/random.hpp"
#include "tests/support/flat_floor.hpp"

namespace weft::agents {
namespace {

Eigen::Vector3d random_unit(Random& random) {
  return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

struct Truth {
  Eigen::Matrix3d rotation;
  Eigen::Vector3d translation;
  Eigen::Vector3d normal;
  Eigen::Matrix3d homography() const { return rotation + translation * normal.transpose(); }
};

/// Returns a plane in front of the camera and a motion in it, of the size that a keyframe sees.
Truth random_truth(Random& random) {
  Truth t;
  do t.normal = random_unit(random);
  while (t.normal.z() < 0.4);
  t.rotation = Eigen::AngleAxisd(random.uniform(-0.3, 0.3), t.normal).toRotationMatrix();
  const Eigen::Vector3d normal_in_b = t.rotation * t.normal;
  const Eigen::Vector3d any = random_unit(random);
  t.translation = random.uniform(0.15, 0.5) * (any - any.dot(normal_in_b) * normal_in_b).normalized();
  return t;
}

TEST(Decompose, OneCandidateIsTheTruth) {
  Random random(11);
  for (int trial = 0; trial < 100; ++trial) {
    const Truth t = random_truth(random);
    double nearest = 1e9;
    for (const PlaneMotion& m : decompose(random.uniform(0.2, 5.0) * t.homography()))
      nearest =
          std::min(nearest, (m.rotation - t.rotation).norm() + (m.translation_in_heights - t.translation).norm() +
                                (m.normal - t.normal).norm());
    EXPECT_LT(nearest, 1e-6) << "trial " << trial;
  }
}

TEST(Decompose, TheMountsNormalChoosesIt) {
  Random random(12);
  for (int trial = 0; trial < 100; ++trial) {
    const Truth t = random_truth(random);
    const Eigen::Vector3d expected =
        Eigen::AngleAxisd(random.uniform(0.0, 0.05), random_unit(random)).toRotationMatrix() * t.normal;
    const Decomposed chosen = choose(decompose(t.homography()), expected, {});
    ASSERT_TRUE(chosen.motion) << "trial " << trial;
    EXPECT_LT((chosen.motion->normal - t.normal).norm(), 1e-6);
    EXPECT_LT((chosen.motion->translation_in_heights - t.translation).norm(), 1e-6);
  }
}

TEST(Decompose, APlaneThatIsNotTheFloorIsRefused) {
  const Eigen::Vector3d floor_normal = Eigen::Vector3d(0.0, 0.67, 0.74).normalized();
  const Truth wall{Eigen::Matrix3d::Identity(), {0.3, 0.0, 0.0}, {0.0, 0.0, 1.0}};
  EXPECT_FALSE(choose(decompose(wall.homography()), floor_normal, {}).motion);
  const Truth up{Eigen::Matrix3d::Identity(), 0.3 * floor_normal, floor_normal};
  EXPECT_FALSE(choose(decompose(up.homography()), floor_normal, {}).motion) << "the robot would have left the floor";
}

TEST(RobustHomography, SurvivesAThirdOfOutliers) {
  Random random(14);
  const Truth t = random_truth(random);
  std::vector<Eigen::Vector2d> a;
  std::vector<Eigen::Vector2d> b;
  for (int i = 0; i < 120; ++i) {
    a.emplace_back(random.uniform(-0.5, 0.5), random.uniform(-0.3, 0.3));
    b.push_back(apply(t.homography(), a.back()));
    if (i % 3 == 2) b.back() += Eigen::Vector2d(random.uniform(0.02, 0.3), random.uniform(0.02, 0.3));
  }
  const auto found = robust_homography(a, b, 0.003);
  ASSERT_TRUE(found);
  EXPECT_GE(found->inliers, 80U);
  for (std::size_t i = 0; i < a.size(); i += 3) {
    EXPECT_TRUE(found->inlier[i]);
    EXPECT_LT((apply(found->b_from_a, a[i]) - b[i]).norm(), 1e-4);
  }
}

TEST(RobustHomography, TooFewGiveNone) {
  const std::vector<Eigen::Vector2d> seven(7, Eigen::Vector2d(0.1, 0.2));
  EXPECT_FALSE(robust_homography(seven, seven, 0.003));
}

TEST(HuberDistance, IsQuadraticThenLinear) {
  EXPECT_EQ(huber_distance(0.0, 100.0), 0.0);
  EXPECT_NEAR(huber_distance(1.0, 100.0), 1.0, 1e-3);
  EXPECT_NEAR(huber_distance(1e6, 100.0), 2.0 * 100.0 * 1e6, 2e-2 * 2e8);
  EXPECT_EQ(huber_distance(-3.0, 10.0), huber_distance(3.0, 10.0));
}

TEST(HuberDistance, OfAHomographyGrowsWithMotion) {
  const CameraModel camera = test::paper_camera();
  EXPECT_NEAR(huber_distance(Eigen::Matrix3d::Identity(), camera, 100.0), 0.0, 1e-12);
  Eigen::Matrix3d shifted = Eigen::Matrix3d::Identity();
  shifted(0, 2) = 10.0 / 460.0;  // every point by 10 px
  EXPECT_NEAR(huber_distance(shifted, camera, 100.0), huber_distance(10.0, 100.0), 1e-6);
}

}  // namespace
}  // namespace weft::agents
