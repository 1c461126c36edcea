#include "agents/perception/clouds/ndt.hpp"

#include <gtest/gtest.h>

#include "agents/perception/clouds/moved.hpp"
#include "tests/agents/perception/clouds/scanned_corner.hpp"

namespace weft::agents {
namespace {

const Pose3 kTruth = se3_exp((Vector6d() << 0.5, -0.1, 0.02, 0.01, -0.01, 0.1).finished());

NdtMap fixed_map(bool has_end_wall) {
  return ndt_map({test::scanned(1, has_end_wall)}, NdtCellConfig{});
}
NdtMap moved_map(bool has_end_wall, const Pose3& a_from_b = kTruth) {
  return ndt_map({moved(test::scanned(2, has_end_wall), a_from_b.inverse())}, NdtCellConfig{});
}
Pose3 off_by(double x, double y, double heading) {
  return kTruth * se3_exp((Vector6d() << x, y, 0.0, 0.0, 0.0, heading).finished());
}
Vector6d error_of(const Registered& registered) {
  return se3_log(kTruth.inverse() * registered.a_from_b.a_from_b);
}

TEST(Ndt, FindsThePoseFromAGuessWhereWallsFaceAllWays) {
  const auto registered = register_from_guess(fixed_map(true), moved_map(true), off_by(0.2, -0.15, 0.08), {});
  ASSERT_TRUE(registered) << registered.error().reason << " " << registered.error().measured;
  EXPECT_LT(error_of(*registered).head<3>().norm(), 0.004);
  EXPECT_LT(error_of(*registered).tail<3>().norm(), 0.002);
  EXPECT_GT(registered->overlap, 0.6);
  EXPECT_EQ(registered->from_prior, 0);
  EXPECT_TRUE(check(Relation(registered->a_from_b)));
}

TEST(Ndt, RefusesByNameWhereCloudsSlideAlongAPlainAisle) {
  const auto registered = register_from_guess(fixed_map(false), moved_map(false), off_by(0.1, 0.05, 0.0), {});
  ASSERT_FALSE(registered);
  EXPECT_EQ(registered.error().reason, "slides");
  EXPECT_GT(registered.error().measured, registered.error().bound);
}

TEST(Ndt, KeepsThePriorAlongAPlainAisleAndGainsAcrossIt) {
  const Metric3 prior{off_by(0.08, 0.06, 0.02), test::covariance_of_sigmas(0.05, 0.02)};
  const auto registered = register_with_prior(fixed_map(false), moved_map(false), prior, {});
  ASSERT_TRUE(registered) << registered.error().reason;
  EXPECT_GE(registered->from_prior, 1);
  const Vector6d error = error_of(*registered);
  EXPECT_NEAR(error[0], 0.08, 0.01) << "along: nothing is known but the prior";
  EXPECT_LT(std::abs(error[1]), 0.01) << "across";
  EXPECT_LT(std::abs(error[5]), 0.005);
  const Matrix6d& covariance = registered->a_from_b.covariance.matrix();
  EXPECT_NEAR(std::sqrt(covariance(0, 0)), 0.05, 0.005) << "along, the prior's own sigma";
  EXPECT_LT(std::sqrt(covariance(1, 1)), 0.02);
}

TEST(Ndt, AWeakPriorDoesNotLetViewsCutOffAtOneRangePullEachOtherTogether) {
  // Both see 4 m ahead of themselves, of an aisle without relief: their overlap is largest where they do not lie.
  const auto seen = [](std::uint64_t seed, double from) {
    std::vector<Eigen::Vector3f> points;
    for (const Eigen::Vector3f& point : test::scanned(seed, false)) {
      if (point.x() > from && point.x() < from + 2.5F) points.push_back(point);
    }
    return points;
  };
  const Pose3 truth = lift({0.5, 0.0, 0.0});
  const NdtMap a = ndt_map({seen(1, -1.5)}, NdtCellConfig{});
  const NdtMap b = ndt_map({moved(seen(2, -1.0), truth.inverse())}, NdtCellConfig{});
  const auto registered = register_with_prior(a, b, {truth, test::covariance_of_sigmas(0.15, 0.05)}, {});
  ASSERT_TRUE(registered) << registered.error().reason;
  EXPECT_LT(std::abs((truth.inverse() * registered->a_from_b.a_from_b).translation.x()), 0.005);
}

TEST(Ndt, RefusesByNameWhatDoesNotOverlapAndWhatIsTooLittle) {
  const auto apart = register_from_guess(fixed_map(true), moved_map(true), kTruth * lift({40.0, 0.0, 0.0}), {});
  ASSERT_FALSE(apart);
  EXPECT_EQ(apart.error().reason, "few_cells");
  const auto nothing = register_from_guess(fixed_map(true), ndt_map({}, NdtCellConfig{}), kTruth, {});
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().reason, "few_cells");
  const auto beside = register_from_guess(fixed_map(true), moved_map(true), kTruth * lift({4.5, 0.0, 0.0}), {});
  ASSERT_FALSE(beside);
}

TEST(Ndt, RefusesByNameWhatContradictsThePrior) {
  const Metric3 sure{off_by(0.08, 0.08, 0.0), test::covariance_of_sigmas(0.01, 0.005)};
  NdtConfig config;
  config.prior_gate = 4.0;
  const auto registered = register_with_prior(fixed_map(true), moved_map(true), sure, config);
  ASSERT_FALSE(registered);
  EXPECT_EQ(registered.error().reason, "disagrees_with_prior");
}

TEST(Ndt, SaysTheSameTwice) {
  const NdtMap a = fixed_map(true);
  const NdtMap b = moved_map(true);
  const auto once = register_from_guess(a, b, off_by(0.1, 0.1, 0.02), {});
  const auto twice = register_from_guess(a, b, off_by(0.1, 0.1, 0.02), {});
  ASSERT_TRUE(once && twice);
  EXPECT_TRUE(identical(Relation(once->a_from_b), Relation(twice->a_from_b)));
}

}  // namespace
}  // namespace weft::agents
