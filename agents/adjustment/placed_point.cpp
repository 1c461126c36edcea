#include "agents/adjustment/placed_point.hpp"

#include <Eigen/LU>
#include <cmath>
#include <vector>

#include "agents/adjustment/costs.hpp"
#include "agents/adjustment/solver_options.hpp"

namespace weft::agents {

MosaicPoint placed(const Mosaic& mosaic, const MosaicIndex& index, std::uint32_t point) {
  using Parameters = std::array<double, 3>;
  constexpr int iterations = 10;
  const std::vector<std::uint32_t>& seen = index.sightings_of(point);
  MosaicPoint result = mosaic.points[point];
  if (seen.empty()) return result;
  std::vector<std::pair<Parameters, Parameters>> from;  // pose and attitude, by sighting
  for (const std::uint32_t number : seen) {
    const MosaicPlace& place = mosaic.places[mosaic.sightings[number].place];
    const Pose2& pose = place.map_from_place;
    const Attitude& attitude = place.attitude;
    from.push_back({{pose.x, pose.y, pose.heading}, {attitude.pitch_rad, attitude.roll_rad, attitude.height_m}});
  }
  ceres::Problem problem;
  Eigen::Vector3d& at = result.in_map;
  problem.AddResidualBlock(HeightCost::make(result), new ceres::HuberLoss(kHuberSigmas), at.data());
  for (std::size_t i = 0; i < seen.size(); ++i) {
    auto& [pose, attitude] = from[i];
    problem.AddResidualBlock(SightingCost::make(mosaic.robot_from_camera, mosaic.sightings[seen[i]]),
                             new ceres::HuberLoss(kHuberSigmas), pose.data(), attitude.data(), at.data());
    problem.SetParameterBlockConstant(pose.data());
    problem.SetParameterBlockConstant(attitude.data());
  }
  ceres::Solver::Summary summary;
  ceres::Solve(repeatable_options(ceres::DENSE_NORMAL_CHOLESKY, iterations), &problem, &summary);
  ceres::CRSMatrix jacobian;
  problem.Evaluate({}, nullptr, nullptr, nullptr, &jacobian);
  const Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>> rows(jacobian.values.data(),
                                                                                         jacobian.num_rows, 3);
  const Eigen::Matrix3d covariance = (rows.transpose() * rows).inverse();
  result.height_sigma_m = std::sqrt(covariance(2, 2));
  return result;
}

}  // namespace weft::agents
