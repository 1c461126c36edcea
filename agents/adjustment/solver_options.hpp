#pragma once
// Private to this room; never included by a public header.
#include <ceres/ceres.h>

namespace weft::agents {

/// Returns options by which a solve depends on its problem alone: so many iterations at most and no time limit, one
/// thread, Eigen's own factorisations whichever BLAS is installed, and nothing is logged.
inline ceres::Solver::Options repeatable_options(ceres::LinearSolverType type, int iterations) {
  ceres::Solver::Options options;
  options.linear_solver_type = type;
  options.dense_linear_algebra_library_type = ceres::EIGEN;
  options.sparse_linear_algebra_library_type = ceres::EIGEN_SPARSE;
  options.max_num_iterations = iterations;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  return options;
}

}  // namespace weft::agents
