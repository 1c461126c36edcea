#include "agents/adjustment/solver_options.hpp"

#include <gtest/gtest.h>

#include <string>

namespace weft::agents {
namespace {

TEST(RepeatableOptions, NothingButTheProblemDecidesWhenASolveEnds) {
  for (const ceres::LinearSolverType type :
       {ceres::DENSE_SCHUR, ceres::DENSE_NORMAL_CHOLESKY, ceres::SPARSE_NORMAL_CHOLESKY}) {
    const ceres::Solver::Options options = repeatable_options(type, 7);
    std::string why;
    EXPECT_TRUE(options.IsValid(&why)) << why;
    EXPECT_EQ(options.linear_solver_type, type);
    EXPECT_EQ(options.max_num_iterations, 7);
    EXPECT_EQ(options.num_threads, 1);
    EXPECT_GE(options.max_solver_time_in_seconds, 1e6) << "a slower machine would end elsewhere";
    EXPECT_EQ(options.dense_linear_algebra_library_type, ceres::EIGEN);
    EXPECT_EQ(options.sparse_linear_algebra_library_type, ceres::EIGEN_SPARSE);
    EXPECT_EQ(options.logging_type, ceres::SILENT);
  }
}

}  // namespace
}  // namespace weft::agents
