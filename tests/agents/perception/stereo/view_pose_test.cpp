#include "agents/perception/stereo/view_pose.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/random.hpp"

namespace weft::agents {
namespace {

const StereoRig kRig{640, 480, 420.0, 319.5, 239.5, 0.12, {}};

Pose3 moved() {
  Vector6d twist;
  twist << 0.05, -0.02, 0.3, 0.02, -0.05, 0.01;
  return se3_exp(twist);
}

/// Returns points whose pixels at b are right but for noise, and a share of them wrong; `in_a` takes where they truly
/// are.
std::vector<SeenPoint> points_seen(const Pose3& b_from_a, double noise_px, double disparity_noise_px, double wrong,
                                   std::uint64_t seed, std::vector<Eigen::Vector3d>* in_a = nullptr,
                                   double nearest_m = 1.5, double farthest_m = 7.0) {
  Random random(seed);
  std::vector<SeenPoint> points;
  while (points.size() < 150) {
    const double z = random.uniform(nearest_m, farthest_m);
    const Eigen::Vector3d true_point((random.uniform(0.0, 640.0) - kRig.cx) / kRig.focal_px * z,
                                     (random.uniform(0.0, 480.0) - kRig.cy) / kRig.focal_px * z, z);
    const Eigen::Vector3d in_b = b_from_a * true_point;
    if (in_b.z() < 0.3) continue;
    SeenPoint point;
    point.disparity_px = kRig.disparity_px(z) + random.normal(0.0, disparity_noise_px);
    point.in_a = true_point * (kRig.disparity_px(z) / point.disparity_px);
    point.at_b = Eigen::Vector2d(kRig.focal_px * in_b.x() / in_b.z() + kRig.cx,
                                 kRig.focal_px * in_b.y() / in_b.z() + kRig.cy) +
                 Eigen::Vector2d(random.normal(0.0, noise_px), random.normal(0.0, noise_px));
    if (random.chance(wrong)) point.at_b = {random.uniform(0.0, 640.0), random.uniform(0.0, 480.0)};
    points.push_back(point);
    if (in_a != nullptr) in_a->push_back(true_point);
  }
  return points;
}

TEST(ViewPose, IsFoundAmongWrongPoints) {
  const std::vector<SeenPoint> points = points_seen(moved(), 0.2, 0.1, 0.4, 5);
  const PoseConsensus consensus = find_pose(kRig, points, {}, {});
  EXPECT_GT(consensus.count, 70U);
  const auto fit = fit_pose(kRig, points, {}, consensus.b_from_a);
  ASSERT_TRUE(fit);
  EXPECT_LT(se3_log(moved().inverse() * fit->b_from_a).norm(), 0.01);
  EXPECT_GT(fit->inliers, 75U);
  EXPECT_LT(fit->inliers, 105U);
}

TEST(ViewPose, ExactPointsGiveTheExactPose) {
  const auto fit = fit_pose(kRig, points_seen(moved(), 0.0, 0.0, 0.0, 5), {}, {});
  ASSERT_TRUE(fit);
  EXPECT_LT(se3_log(moved().inverse() * fit->b_from_a).norm(), 1e-6);
  EXPECT_EQ(fit->inliers, 150U);
}

TEST(ViewPose, ItsCovarianceIsThatOfItsErrors) {
  PoseBounds bounds;
  double squares = 0.0;
  constexpr int rounds = 60;
  for (std::uint64_t seed = 1; seed <= rounds; ++seed) {
    const auto points = points_seen(moved(), bounds.track_sigma_px, bounds.disparity_sigma_px, 0.0, seed);
    const auto fit = fit_pose(kRig, points, bounds, moved());
    ASSERT_TRUE(fit);
    const Vector6d off = se3_log(fit->b_from_a * moved().inverse());  // of a_from_b, as the covariance has it
    squares += off.dot(fit->covariance.inverse() * off);
  }
  EXPECT_NEAR(squares / (6.0 * rounds), 1.0, 0.35);
}

TEST(ViewPose, DisparitiesAtTheViewMakeItSurer) {
  const PoseBounds bounds;
  double squares = 0.0;
  double without_m2 = 0.0;
  double with_m2 = 0.0;
  constexpr int rounds = 60;
  for (std::uint64_t seed = 1; seed <= rounds; ++seed) {
    std::vector<Eigen::Vector3d> true_points;
    auto points = points_seen(moved(), bounds.track_sigma_px, bounds.disparity_sigma_px, 0.0, seed, &true_points);
    std::size_t next = 0;
    const auto without = fit_pose(kRig, points, bounds, moved());
    Random random(1000 + seed);
    for (SeenPoint& point : points) {
      const double depth_m = (moved() * true_points[next++]).z();
      point.disparity_at_b_px = kRig.disparity_px(depth_m) + random.normal(0.0, bounds.disparity_sigma_px);
    }
    const auto with = fit_pose(kRig, points, bounds, moved());
    ASSERT_TRUE(without && with);
    const Vector6d off = se3_log(with->b_from_a * moved().inverse());
    squares += off.dot(with->covariance.inverse() * off);
    with_m2 += off.head<3>().squaredNorm();
    without_m2 += se3_log(without->b_from_a * moved().inverse()).head<3>().squaredNorm();
  }
  EXPECT_NEAR(squares / (6.0 * rounds), 1.0, 0.35) << "its covariance is that of its errors";
  EXPECT_LT(with_m2, 0.9 * without_m2);
}

TEST(ViewPose, NoiseOfDisparitiesDoesNotShortenTheWay) {
  PoseBounds bounds;
  bounds.disparity_sigma_px = 0.5;
  Pose3 ahead;
  ahead.translation.z() = -1.0;
  double sum_m = 0.0;
  double sigma2_m2 = 0.0;
  constexpr int rounds = 100;
  for (std::uint64_t seed = 1; seed <= rounds; ++seed) {
    // Far away: disparities of 2 to 6 px.
    const auto points =
        points_seen(ahead, bounds.track_sigma_px, bounds.disparity_sigma_px, 0.0, seed, nullptr, 8.0, 25.0);
    const auto fit = fit_pose(kRig, points, bounds, ahead);
    ASSERT_TRUE(fit);
    sum_m += (fit->b_from_a * ahead.inverse()).translation.z();
    sigma2_m2 += fit->covariance(2, 2);
  }
  RecordProperty("mean_off_m", std::to_string(sum_m / rounds));
  EXPECT_LT(std::abs(sum_m / rounds), 3.0 * std::sqrt(sigma2_m2) / rounds) << "of 1 m";
}

TEST(ViewPose, TheSamePointsGiveTheSamePose) {
  const std::vector<SeenPoint> points = points_seen(moved(), 0.3, 0.2, 0.5, 9);
  const PoseConsensus one = find_pose(kRig, points, {}, {});
  const PoseConsensus other = find_pose(kRig, points, {}, {});
  EXPECT_EQ(one.count, other.count);
  EXPECT_EQ(one.b_from_a.translation, other.b_from_a.translation);
}

TEST(ViewPose, FewPointsGiveNone) {
  std::vector<SeenPoint> points = points_seen(moved(), 0.1, 0.1, 0.0, 5);
  points.resize(5);
  EXPECT_FALSE(fit_pose(kRig, points, {}, {}));
}

}  // namespace
}  // namespace weft::agents
