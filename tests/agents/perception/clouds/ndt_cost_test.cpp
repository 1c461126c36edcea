// The derivatives of the cost against numeric ones.
#include "agents/perception/clouds/ndt_cost.hpp"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include "agents/perception/clouds/moved.hpp"
#include "tests/agents/perception/clouds/scanned_corner.hpp"

namespace weft::agents {
namespace {

struct NdtCosts : testing::Test {
  double at(const Vector6d& twist) const { return cost(twist).value; }
  NdtCost cost(const Vector6d& twist) const {
    return ndt_cost(a, b, a_from_b * se3_exp(twist), config, CellsOfB::all, false);
  }
  static NdtLevel level_of(const std::vector<Eigen::Vector3f>& points) {
    return ndt_map({points}, NdtCellConfig{}).levels.at(1);
  }

  const Pose3 a_from_b = se3_exp((Vector6d() << 0.4, -0.1, 0.05, 0.02, -0.03, 0.2).finished());
  const Pose3 off_by = se3_exp((Vector6d() << 0.02, 0.03, -0.02, 0.01, 0.005, -0.01).finished());
  NdtLevel a = level_of(test::scanned(1, true));
  NdtLevel b = level_of(moved(test::scanned(2, true), (a_from_b * off_by).inverse()));
  NdtCostConfig config{};
};

TEST_F(NdtCosts, GradientIsTheSlopeOfTheValue) {
  const NdtCost here = cost(Vector6d::Zero());
  constexpr double step = 1e-6;
  for (int axis = 0; axis < 6; ++axis) {
    const Vector6d by = step * Vector6d::Unit(axis);
    const double slope = (at(by) - at(-by)) / (2.0 * step);
    EXPECT_NEAR(here.gradient[axis], slope, 1e-4 * here.gradient.norm()) << "axis " << axis;
  }
}

TEST_F(NdtCosts, HessianIsTheSlopeOfTheGradient) {
  const NdtCost here = cost(Vector6d::Zero());
  constexpr double step = 2e-6;  // small, so that no cell of b comes to lie among others of a
  for (int one = 0; one < 6; ++one) {
    for (int other = 0; other < 6; ++other) {  // of the value twice: a gradient belongs to its own pose's frame
      const Vector6d first = step * Vector6d::Unit(one);
      const Vector6d second = step * Vector6d::Unit(other);
      const double slope =
          (at(first + second) - at(first - second) - at(second - first) + at(-first - second)) / (4.0 * step * step);
      EXPECT_NEAR(here.hessian(one, other), slope, 2e-3 * here.hessian.norm()) << one << ", " << other;
    }
  }
}

TEST_F(NdtCosts, HessianIsSymmetricAndTheInformationNeverNegative) {
  const NdtCost here = cost(Vector6d::Constant(0.05));
  EXPECT_LT((here.hessian - here.hessian.transpose()).norm(), 1e-9 * here.hessian.norm());
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(here.information);
  EXPECT_GT(solver.eigenvalues()[0], 0.0);
}

TEST_F(NdtCosts, CloudsThatDoNotMeetCostNothing) {
  const NdtCost apart = cost((Vector6d() << 50.0, 0.0, 0.0, 0.0, 0.0, 0.0).finished());
  EXPECT_EQ(apart.value, 0.0);
  EXPECT_EQ(apart.matched, 0U);
  EXPECT_EQ(apart.information.norm(), 0.0);
}

TEST_F(NdtCosts, TheScatterOfTheGradientIsThatOfRepeatedScans) {
  // Compares the gradient's covariance over clouds seen anew, by seeds, with the one computed of one cloud.
  const Pose3 truth = a_from_b * off_by;
  Matrix6d scatter = Matrix6d::Zero();
  Matrix6d stated = Matrix6d::Zero();
  Vector6d mean = Vector6d::Zero();
  constexpr int runs = 40;
  for (std::uint64_t seed = 0; seed < runs; ++seed) {
    const NdtLevel one = level_of(test::scanned(100 + 2 * seed, true));
    const NdtLevel two = level_of(moved(test::scanned(101 + 2 * seed, true), truth.inverse()));
    const NdtCost there = ndt_cost(one, two, truth, config, CellsOfB::all, true);
    scatter += there.gradient * there.gradient.transpose() / runs;
    mean += there.gradient / runs;
    stated += there.scatter / runs;
  }
  scatter -= mean * mean.transpose();
  for (int axis = 0; axis < 6; ++axis) {
    EXPECT_GT(stated(axis, axis), 0.2 * scatter(axis, axis)) << "axis " << axis;
    EXPECT_LT(stated(axis, axis), 5.0 * scatter(axis, axis)) << "axis " << axis;
  }
}

TEST_F(NdtCosts, WhatOneCloudAloneSaysAlongAPlainAisleIsNotTrusted) {
  const Pose3 truth = a_from_b * off_by;
  const auto along = [&](bool has_end_wall) {  // of the aisle: what a's cells say, and what both clouds' do
    const NdtLevel one = level_of(test::scanned(1, has_end_wall));
    const NdtLevel two = level_of(moved(test::scanned(2, has_end_wall), truth.inverse()));
    const NdtCost there = ndt_cost(one, two, truth, config, CellsOfB::all, true);
    const Eigen::Vector3d x_in_b = truth.inverse().rotation * Eigen::Vector3d::UnitX();
    return std::pair{x_in_b.dot(there.information.topLeftCorner<3, 3>() * x_in_b),
                     x_in_b.dot(there.trusted.topLeftCorner<3, 3>() * x_in_b)};
  };
  const auto [plain, plain_trusted] = along(false);
  EXPECT_GT(plain, 0.0);
  EXPECT_LT(std::abs(plain_trusted), 0.3 * plain);
  const auto [ended, ended_trusted] = along(true);
  EXPECT_GT(ended_trusted, 0.8 * ended);
  EXPECT_GT(ended_trusted, 20.0 * std::abs(plain_trusted));
}

TEST_F(NdtCosts, OfLargerCellsThoseAreMatchedWhosePointsNoSmallerOnesHold) {
  const NdtCost all = cost(Vector6d::Zero());
  for (NdtCell& cell : b.cells) cell.is_finest = false;
  b.cells.front().is_finest = true;
  const NdtCost finest = ndt_cost(a, b, a_from_b, config, CellsOfB::finest, false);
  EXPECT_EQ(all.cells, b.cells.size());
  EXPECT_EQ(finest.cells, 1U);
}

}  // namespace
}  // namespace weft::agents
