#include <gmock/gmock.h>

#include <cmath>
#include <utility>

#include "agents/methods/topometric/free_space.hpp"
#include "agents/methods/topometric/space_consensus.hpp"
#include "core/random.hpp"
#include "tests/agents/methods/topometric/sim_drive.hpp"

namespace weft::agents {
namespace {

/// Holds a place with where it truly is.
struct Kept {
  TopometricContent content;
  Pose2 site_from_place;
};

/// Returns places of a drive through the hall, half a metre apart; made once.
const std::vector<Kept>& hall_places() {
  static const std::vector<Kept> places = [] {
    std::vector<Kept> kept;
    test::SimDrive drive(test::topometric_site("hall"), {2.0, 1.8, 0.0});
    drive.drive(0.9);
    for (int i = 0; i < 3; ++i) {
      kept.push_back({drive.place(), drive.truth()});
      drive.drive(0.5);
    }
    return kept;
  }();
  return places;
}

const Topometric& method() {
  static const Topometric made = [] {
    Rig rig;
    rig.sensors.push_back({"stereo", SensorKind::stereo, {}, CameraModel{}});
    Sensor& pair = rig.sensors.front();
    pair.camera.width = 320;
    pair.camera.height = 240;
    pair.camera.fx = pair.camera.fy = 208.0;
    pair.camera.cx = 159.5;
    pair.camera.cy = 119.5;
    pair.camera.robot_from_camera = downward_mount(0.15, 0.06, 0.45, 0.1, 0.0, 0.0);
    pair.right = pair.camera;
    pair.right->robot_from_camera =
        pair.camera.robot_from_camera * Pose3{Eigen::Quaterniond::Identity(), {0.12, 0.0, 0.0}};
    return std::move(*Topometric::make({}, rig));
  }();
  return made;
}

Pose2 true_relation(const Kept& a, const Kept& b) {
  return a.site_from_place.inverse() * b.site_from_place;
}

void expect_near(const Relation& relation, const Pose2& truth, double metres, double radians) {
  const Pose2 off = truth.inverse() * planar(relation);
  EXPECT_LT(off.translation().norm(), metres);
  EXPECT_LT(std::abs(off.heading), radians);
}

Relation guess_about(const Pose2& truth, const Eigen::Vector3d& off, double sigma_m, double sigma_rad) {
  return Metric2{truth * se2_exp(off),
                 Eigen::Vector3d(sigma_m * sigma_m, sigma_m * sigma_m, sigma_rad * sigma_rad).asDiagonal()};
}

TEST(TopometricRelate, TwoViewsOfOneHallAreRelatedWithAGuess) {
  const Kept& a = hall_places()[0];
  const Kept& b = hall_places()[1];
  const Pose2 truth = true_relation(a, b);
  const auto related = method().relate(a.content, b.content, guess_about(truth, {0.08, -0.06, 0.03}, 0.1, 0.05));
  ASSERT_TRUE(related) << related.error().reason << " " << related.error().measured;
  expect_near(related->a_from_b, truth, 0.03, 0.0087);
  EXPECT_GT(related->inliers, 11U);
  EXPECT_GT(related->overlap, 0.3);
}

TEST(TopometricRelate, AndWithoutOne) {
  const Kept& a = hall_places()[0];
  const Kept& b = hall_places()[1];
  const auto related = method().relate(a.content, b.content, std::nullopt);
  ASSERT_TRUE(related) << related.error().reason << " " << related.error().measured;
  expect_near(related->a_from_b, true_relation(a, b), 0.03, 0.0087);
}

TEST(TopometricRelate, WhatIsNewThereHidesNoPlaceAndIsTold) {
  sim::Site site = test::topometric_site("hall");
  sim::Obstacle crate;
  crate.name = "crate";
  crate.site_from_obstacle = {5.0, 1.6, 0.0};
  crate.length_m = 0.6;
  crate.width_m = 0.5;
  crate.height_m = 0.6;
  site.obstacles.push_back(crate);
  test::SimDrive drive(site, {2.0, 1.8, 0.0});
  drive.drive(0.9);
  const Kept now{drive.place(), drive.truth()};
  const Kept& before = hall_places()[0];
  const auto related = method().relate(before.content, now.content, std::nullopt);
  ASSERT_TRUE(related) << related.error().reason << " " << related.error().measured;
  expect_near(related->a_from_b, true_relation(before, now), 0.03, 0.0087);
  EXPECT_GT(related->doubt, 0.05);
  const auto same = method().relate(before.content, hall_places()[1].content, std::nullopt);
  ASSERT_TRUE(same);
  EXPECT_LT(same->doubt, 0.05);
}

TEST(TopometricRelate, AnotherPlaceIsRefused) {
  test::SimDrive elsewhere(test::topometric_site("level11"), {6.0, 0.9, 0.0});
  elsewhere.drive(0.9);
  const auto related = method().relate(hall_places()[0].content, elsewhere.place(), std::nullopt);
  ASSERT_FALSE(related);
  EXPECT_THAT(std::string(related.error().reason), testing::StartsWith("few_"));
  const auto guessed = method().relate(hall_places()[0].content, elsewhere.place(),
                                       guess_about({0.5, 0.0, 0.0}, Eigen::Vector3d::Zero(), 0.1, 0.05));
  EXPECT_FALSE(guessed);
}

TEST(TopometricRelate, AGuessThatIsWrongIsNotBelieved) {
  const Kept& a = hall_places()[0];
  const Kept& b = hall_places()[1];
  const auto related =
      method().relate(a.content, b.content, guess_about(true_relation(a, b), {0.9, 0.0, 0.0}, 0.03, 0.02));
  EXPECT_FALSE(related);
}

TEST(TopometricRegistered, IsNoWorseThanOdometryAndSurer) {
  const Kept& a = hall_places()[1];
  const Kept& b = hall_places()[2];
  const Pose2 truth = true_relation(a, b);
  const Relation odometry = guess_about(truth, {0.02, 0.015, 0.01}, 0.02, 0.01);
  const Relation registered = method().registered(a.content, b.content, odometry);
  ASSERT_TRUE(std::holds_alternative<Metric3>(registered));
  EXPECT_TRUE(check(registered));
  expect_near(registered, truth, 0.03, 0.0087);
  EXPECT_LT(planar_covariance(registered).trace(), planar_covariance(odometry).trace());
}

TEST(TopometricRegistered, PlacesThatDoNotAgreeStayAsOdometryHasThem) {
  TopometricContent blank = hall_places()[0].content;
  blank.cloud.points.clear();
  blank.cloud.frames.clear();
  blank.features.clear();
  const Relation odometry = guess_about({0.5, 0.0, 0.1}, Eigen::Vector3d::Zero(), 0.02, 0.01);
  const Relation registered = method().registered(blank, hall_places()[1].content, odometry);
  expect_near(registered, {0.5, 0.0, 0.1}, 1e-2, 1e-3);
  EXPECT_NEAR(planar_covariance(registered)(0, 0), 4e-4, 1e-4);
  const Relation along = AlongPath{0.5, 0.01, 0.0, 0.01};
  EXPECT_TRUE(identical(method().registered(blank, blank, along), along));
}

/// Returns a cloud of a wall across the way, `ahead_m` away, seen from the origin.
PlaceCloud wall_ahead(float ahead_m) {
  PlaceCloud cloud;
  cloud.place_from_frames.emplace_back();
  cloud.cameras.emplace_back(0.0F, 0.0F, 0.45F);
  for (float y = -1.0F; y <= 1.0F; y += 0.02F)
    for (float z = 0.2F; z <= 1.2F; z += 0.1F) {
      cloud.points.emplace_back(ahead_m, y, z);
      cloud.frames.push_back(0);
    }
  return cloud;
}

TEST(TopometricFreeSpace, WhatStandsWhereRaysHavePassedIsFound) {
  const PlaceCloud a = wall_ahead(3.0F);
  EXPECT_EQ(standing_in_free(a, a, Pose3{}, {}, {}).share, 0.0);
  EXPECT_GT(standing_in_free(a, wall_ahead(2.0F), Pose3{}, {}, {}).share, 0.7) << "before the wall";
  EXPECT_EQ(standing_in_free(a, wall_ahead(4.0F), Pose3{}, {}, {}).share, 0.0) << "behind it nobody looked";
  const DepthNoise noise{208.0, 0.12, 1.0};
  EXPECT_EQ(standing_in_free(a, wall_ahead(2.6F), Pose3{}, {}, noise).share, 0.0) << "as far off as its depth may be";
}

TEST(TopometricConsensus, FindsTheMotionThatMostPairsShare) {
  Random random(3);
  const Pose3 truth = lift(Pose2{0.6, -0.2, 0.4});
  std::vector<SpacePair> pairs;
  for (int i = 0; i < 80; ++i) {
    const Eigen::Vector3d in_b(random.uniform(1.0, 5.0), random.uniform(-2.0, 2.0), random.uniform(0.0, 2.0));
    const Eigen::Vector3d noise(random.normal(), random.normal(), random.normal());
    const Eigen::Vector3d elsewhere(random.uniform(1.0, 5.0), random.uniform(-2.0, 2.0), random.uniform(0.0, 2.0));
    pairs.push_back({i % 2 == 0 ? Eigen::Vector3d(truth * in_b + 0.014 * noise) : elsewhere, in_b,
                     1e-4 * Eigen::Matrix3d::Identity(), 1e-4 * Eigen::Matrix3d::Identity()});
  }
  const RelateConfig config;
  const SpaceConsensus consensus = find_space_consensus(config, pairs);
  EXPECT_GE(consensus.inliers.size(), 30U);
  const Metric3 prior{consensus.a_from_b, Matrix6d::Identity()};
  const auto fit = fit_space_motion(config, pairs, consensus, prior);
  ASSERT_TRUE(fit);
  EXPECT_GE(fit->inliers.size(), 36U);
  EXPECT_LE(fit->inliers.size(), 44U);
  EXPECT_LT((fit->a_from_b.a_from_b.translation - truth.translation).norm(), 0.015);
  const double sigma_m = std::sqrt(fit->a_from_b.covariance.matrix()(0, 0));
  EXPECT_GT(sigma_m, 0.001);
  EXPECT_LT(sigma_m, 0.02);
  EXPECT_TRUE(find_space_consensus(config, {}).inliers.empty());
}

}  // namespace
}  // namespace weft::agents
