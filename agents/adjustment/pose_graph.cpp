#include "agents/adjustment/pose_graph.hpp"

#include <Eigen/Cholesky>
#include <array>
#include <cmath>

#include "agents/adjustment/costs.hpp"
#include "agents/adjustment/solver_options.hpp"

namespace weft::agents {
namespace {

constexpr double kCauchySigmas = 3.0;
constexpr int kStride = 4;

/// Compares the places of a window with how they were fitted. Parameters: their poses in order.
class WindowCost {
 public:
  WindowCost(const WindowFit& fit, double share)
      : fit_(fit), in_sigmas_(std::sqrt(share) * Eigen::MatrixXd(fit.information.llt().matrixU())) {}

  static ceres::CostFunction* make(const WindowFit& fit, double share) {
    auto* const cost = new ceres::DynamicAutoDiffCostFunction<WindowCost, kStride>(new WindowCost(fit, share));
    for (std::size_t i = 0; i < fit.first_from_place.size(); ++i) cost->AddParameterBlock(3);
    cost->SetNumResiduals(static_cast<int>(fit.information.rows()));
    return cost;
  }

  template <class T>
  bool operator()(T const* const* poses, T* residual) const {
    Eigen::Matrix<T, Eigen::Dynamic, 1> off(in_sigmas_.rows());
    for (std::size_t i = 1; i < fit_.first_from_place.size(); ++i)
      off.template segment<3>(3 * (static_cast<Eigen::Index>(i) - 1)) =
          off_from(poses[0], poses[i], fit_.first_from_place[i]);
    Eigen::Map<Eigen::Matrix<T, Eigen::Dynamic, 1>>(residual, off.rows()) = in_sigmas_.template cast<T>() * off;
    return true;
  }

 private:
  const WindowFit& fit_;
  Eigen::MatrixXd in_sigmas_;
};

}  // namespace

bool adjust_poses(std::vector<Pose2>& map_from_place, std::span<const WindowFit> windows,
                  std::span<const MosaicLink> stitches, double share, int iterations) {
  std::vector<std::array<double, 3>> poses;
  poses.reserve(map_from_place.size());
  for (const Pose2& pose : map_from_place) poses.push_back({pose.x, pose.y, pose.heading});
  ceres::Problem problem;
  for (const WindowFit& window : windows) {
    std::vector<double*> of_window;
    for (std::size_t i = 0; i < window.first_from_place.size(); ++i)
      of_window.push_back(poses[window.first + i].data());
    problem.AddResidualBlock(WindowCost::make(window, share), nullptr, of_window);
  }
  for (const MosaicLink& stitch : stitches)
    problem.AddResidualBlock(LinkCost::make(stitch), new ceres::CauchyLoss(kCauchySigmas), poses[stitch.from].data(),
                             poses[stitch.to].data());
  problem.SetParameterBlockConstant(poses.front().data());
  ceres::Solver::Summary summary;
  ceres::Solve(repeatable_options(ceres::SPARSE_NORMAL_CHOLESKY, iterations), &problem, &summary);
  for (std::size_t i = 0; i < poses.size(); ++i)
    map_from_place[i] = {poses[i][0], poses[i][1], wrap_angle(poses[i][2])};
  return summary.termination_type == ceres::CONVERGENCE;
}

}  // namespace weft::agents
