#include "core/network/relation.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <cmath>

#include "core/network/codec.hpp"
#include "tests/support/network_maker.hpp"

namespace weft {
namespace {

template <class Tangent, class Matrix>
Tangent draw(Random& random, const Matrix& covariance) {
  Tangent standard;
  for (double& axis : standard) axis = random.normal();
  return covariance.llt().matrixL() * standard;
}

/// Returns the largest difference relative to the largest entry.
template <class Matrix>
double difference(const Matrix& a, const Matrix& b) {
  return (a - b).cwiseAbs().maxCoeff() / b.cwiseAbs().maxCoeff();
}

constexpr int kDraws = 20'000;

TEST(Relation, PlanarCovariancesComposeLikeSamples) {
  Random random(7);
  const Metric2 ab{{1.0, -0.4, 0.8}, support::random_covariance<3>(random, 0.01)};
  const Metric2 bc{{-0.3, 2.0, -1.9}, support::random_covariance<3>(random, 0.01)};
  const auto composed = std::get<Metric2>(compose(ab, bc));
  const auto turned = std::get<Metric2>(inverse(ab));
  Eigen::Matrix3d sampled = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d sampled_inverse = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kDraws; ++i) {
    const Pose2 noisy_ab = ab.a_from_b * se2_exp(draw<Eigen::Vector3d>(random, ab.covariance));
    const Pose2 noisy_bc = bc.a_from_b * se2_exp(draw<Eigen::Vector3d>(random, bc.covariance));
    const Eigen::Vector3d xi = se2_log(composed.a_from_b.inverse() * noisy_ab * noisy_bc);
    const Eigen::Vector3d eta = se2_log(turned.a_from_b.inverse() * noisy_ab.inverse());
    sampled += xi * xi.transpose() / kDraws;
    sampled_inverse += eta * eta.transpose() / kDraws;
  }
  EXPECT_LT(difference(sampled, composed.covariance), 0.05);
  EXPECT_LT(difference(sampled_inverse, turned.covariance), 0.05);
}

TEST(Relation, SpatialCovariancesComposeLikeSamples) {
  Random random(8);
  const Metric3 ab{support::random_metric3(random).a_from_b, support::random_covariance<6>(random, 0.01)};
  const Metric3 bc{support::random_metric3(random).a_from_b, support::random_covariance<6>(random, 0.01)};
  const auto composed = std::get<Metric3>(compose(ab, bc));
  Matrix6d sampled = Matrix6d::Zero();
  for (int i = 0; i < kDraws; ++i) {
    const Pose3 noisy_ab = ab.a_from_b * se3_exp(draw<Vector6d>(random, ab.covariance.matrix()));
    const Pose3 noisy_bc = bc.a_from_b * se3_exp(draw<Vector6d>(random, bc.covariance.matrix()));
    const Vector6d xi = se3_log(composed.a_from_b.inverse() * noisy_ab * noisy_bc);
    sampled += xi * xi.transpose() / kDraws;
  }
  EXPECT_LT(difference(sampled, composed.covariance.matrix()), 0.05);
}

TEST(Relation, ProjectedCovarianceIsThatOfProjectedSamples) {
  Random random(9);
  Vector6d twist;
  twist << 1.0, 2.0, 0.5, 0.3, -0.4, 1.2;
  const Metric3 metric{se3_exp(twist), support::random_covariance<6>(random, 0.005)};
  const Pose2 flat = planar(metric);
  Eigen::Matrix3d sampled = Eigen::Matrix3d::Zero();
  for (int i = 0; i < kDraws; ++i) {
    const Eigen::Vector3d xi = se2_log(
        flat.inverse() * project(metric.a_from_b * se3_exp(draw<Vector6d>(random, metric.covariance.matrix()))));
    sampled += xi * xi.transpose() / kDraws;
  }
  EXPECT_LT(difference(sampled, planar_covariance(metric)), 0.05);
}

TEST(Relation, InverseOfInverseIsTheRelation) {
  Random random(10);
  for (int i = 0; i < 200; ++i) {
    const Metric2 flat = support::random_metric2(random);
    const auto back2 = std::get<Metric2>(inverse(inverse(flat)));
    EXPECT_LT((back2.a_from_b.translation() - flat.a_from_b.translation()).norm(), 1e-12);
    EXPECT_LT((back2.covariance - flat.covariance).norm(), 1e-12);
    const Metric3 metric = support::random_metric3(random);
    const auto back3 = std::get<Metric3>(inverse(inverse(metric)));
    EXPECT_LT((back3.a_from_b.translation - metric.a_from_b.translation).norm(), 1e-12);
    EXPECT_LT((back3.covariance.matrix() - metric.covariance.matrix()).norm(), 1e-12);
    const AlongPath path = support::random_along_path(random);
    EXPECT_EQ(encode(inverse(inverse(Relation(path)))), encode(Relation(path)));
  }
}

TEST(Relation, ComposedWithItsInverseLeadsNowhere) {
  Random random(11);
  for (int i = 0; i < 200; ++i) {
    const Relation relation = support::random_relation(random);
    EXPECT_LT(norm(compose(relation, inverse(relation))), 1e-7);
  }
}

TEST(Relation, NormIsThatOfTheInverse) {
  Random random(12);
  for (int i = 0; i < 500; ++i) {
    const Relation relation = support::random_relation(random);
    EXPECT_NEAR(norm(relation), norm(inverse(relation)), 1e-9);
    EXPECT_NEAR(distance_m(relation), distance_m(inverse(relation)), 1e-9);
    EXPECT_GE(norm(relation, 0.0), 0.0);
    EXPECT_NEAR(norm(relation, 0.0), distance_m(relation), 1e-12);
    EXPECT_GE(norm(relation, 2.0), norm(relation, 1.0));
  }
  EXPECT_DOUBLE_EQ(norm(Metric2{{3.0, 0.0, 0.0}}), 3.0);
  EXPECT_DOUBLE_EQ(norm(Metric2{{0.0, 0.0, 1.0}}, 0.5), 0.5);
}

TEST(Relation, KindsMixDownwards) {
  Random random(13);
  const Relation flat = support::random_metric2(random);
  const Relation spatial = support::random_metric3(random);
  const Relation path = support::random_along_path(random);
  EXPECT_TRUE(std::holds_alternative<Metric2>(compose(flat, flat)));
  EXPECT_TRUE(std::holds_alternative<Metric3>(compose(flat, spatial)));
  EXPECT_TRUE(std::holds_alternative<Metric3>(compose(spatial, flat)));
  EXPECT_TRUE(std::holds_alternative<Metric3>(compose(spatial, spatial)));
  for (const Relation& other : {flat, spatial, path}) {
    EXPECT_TRUE(std::holds_alternative<AlongPath>(compose(path, other)));
    EXPECT_TRUE(std::holds_alternative<AlongPath>(compose(other, path)));
  }
}

TEST(Relation, APlanarOneIsTheSameWhenRaised) {
  Random random(14);
  const Metric2 ab = support::random_metric2(random);
  const Metric2 bc = support::random_metric2(random);
  const Relation raised = compose(compose(ab, Metric3{}), bc);
  const Relation flat = compose(ab, bc);
  EXPECT_NEAR(planar(raised).x, planar(flat).x, 1e-12);
  EXPECT_NEAR(heading_rad(raised), heading_rad(flat), 1e-12);
  EXPECT_LT((planar_covariance(raised) - planar_covariance(flat)).norm(), 1e-12);
}

TEST(Relation, AlongThePathIsSignedByTheDirectionOfTravel) {
  const Relation none = AlongPath{};
  const auto ahead = std::get<AlongPath>(compose(none, Metric2{{2.0, 0.5, 0.4}}));
  const auto behind = std::get<AlongPath>(compose(none, inverse(Metric2{{2.0, 0.5, 0.4}})));
  EXPECT_NEAR(ahead.distance_m, std::hypot(2.0, 0.5), 1e-12);
  EXPECT_NEAR(behind.distance_m, -ahead.distance_m, 1e-12);
  EXPECT_NEAR(behind.heading_shift_rad, -ahead.heading_shift_rad, 1e-12);
  EXPECT_DOUBLE_EQ(planar(AlongPath{-1.5, 0.0, 0.2, 0.0}).x, -1.5);
}

TEST(Relation, IdenticalMeansTheSameBytes) {
  Random random(17);
  for (int i = 0; i < 100; ++i) {
    const Relation one = support::random_relation(random);
    const Relation other = support::random_relation(random);
    EXPECT_TRUE(identical(one, one));
    EXPECT_FALSE(identical(one, other));
    EXPECT_EQ(identical(one, inverse(one)), encode(one) == encode(inverse(one)));
  }
  EXPECT_FALSE(identical(AlongPath{0.0, 0.0, 0.0, 0.0}, AlongPath{-0.0, 0.0, 0.0, 0.0}));
}

TEST(Relation, WhatIsNoRelationIsRefused) {
  const auto code = [](const Relation& relation) {
    const Result<void> checked = check(relation);
    return checked ? ErrorCode::internal : checked.error().code;
  };
  Random random(15);
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(check(support::random_relation(random)));
  EXPECT_TRUE(check(Metric2{}));
  EXPECT_EQ(code(Metric2{{NAN, 0.0, 0.0}, Eigen::Matrix3d::Zero()}), ErrorCode::invalid);
  EXPECT_EQ(code(Metric2{{}, -Eigen::Matrix3d::Identity()}), ErrorCode::invalid);
  Eigen::Matrix3d lopsided = Eigen::Matrix3d::Identity();
  lopsided(0, 1) = 0.1;
  EXPECT_EQ(code(Metric2{{}, lopsided}), ErrorCode::invalid);
  lopsided(0, 1) = NAN;
  EXPECT_EQ(code(Metric2{{}, lopsided}), ErrorCode::invalid);
  Eigen::Matrix3d saddle = Eigen::Matrix3d::Identity();
  saddle(0, 1) = saddle(1, 0) = 1.1;
  EXPECT_EQ(code(Metric2{{}, saddle}), ErrorCode::invalid);
  Metric3 stretched;
  stretched.a_from_b.rotation.w() = 1.001;
  EXPECT_EQ(code(stretched), ErrorCode::invalid);
  Metric3 unknown;
  unknown.a_from_b.translation.x() = INFINITY;
  EXPECT_EQ(code(unknown), ErrorCode::invalid);
  EXPECT_EQ(code(AlongPath{0.0, -1.0, 0.0, 0.0}), ErrorCode::invalid);
  EXPECT_EQ(code(AlongPath{0.0, 0.0, 0.0, -1.0}), ErrorCode::invalid);
  EXPECT_EQ(code(AlongPath{NAN, 0.0, 0.0, 0.0}), ErrorCode::invalid);
}

TEST(Relation, IsNoLargerThanThePlaneNeeds) {
  EXPECT_LE(sizeof(Relation), 112U) << "a map has millions of them";
  EXPECT_LE(sizeof(Edge), 192U);
}

TEST(Relation, CopiesOfASpatialOneLeaveEachOtherAlone) {
  const Metric3 before{lift({1, 2, 0.5}), Matrix6d::Identity()};
  Metric3 after = before;
  after.covariance = 2.0 * after.covariance.matrix();
  EXPECT_EQ(before.covariance.matrix()(0, 0), 1.0);
  EXPECT_EQ(after.covariance.matrix()(0, 0), 2.0);
  EXPECT_EQ(Metric3{}.covariance.matrix(), Matrix6d::Zero());
  EXPECT_TRUE(identical(before, Metric3{lift({1, 2, 0.5}), Matrix6d::Identity()}));
  EXPECT_FALSE(identical(before, after));
  EXPECT_TRUE(identical(Metric3{}, Metric3{Pose3{}, Matrix6d::Zero()}));
}

TEST(Relation, LongChainsStayRelations) {
  Random random(16);
  Relation flat = Metric2{};
  Relation spatial = Metric3{};
  for (int i = 0; i < 5000; ++i) {
    flat = compose(flat, support::random_step(random));
    spatial = compose(spatial, support::random_metric3(random, 0.2));
  }
  EXPECT_TRUE(check(flat));
  EXPECT_TRUE(check(spatial));
}

}  // namespace
}  // namespace weft
