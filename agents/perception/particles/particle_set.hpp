#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "core/geometry/pose2.hpp"

namespace weft::agents {

/// Holds weighted poses, number by number, so that many are computed with at once. Weights add up to 1.
struct ParticleSet {
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> heading;
  std::vector<double> weight;

  std::size_t size() const { return weight.size(); }
  Pose2 pose(std::size_t i) const {
    return {static_cast<double>(x[i]), static_cast<double>(y[i]), static_cast<double>(heading[i])};
  }
  void set(std::size_t i, const Pose2& pose) {
    x[i] = static_cast<float>(pose.x);
    y[i] = static_cast<float>(pose.y);
    heading[i] = static_cast<float>(pose.heading);
  }
  void add(const Pose2& pose, double weight_of_it) {
    x.push_back(static_cast<float>(pose.x));
    y.push_back(static_cast<float>(pose.y));
    heading.push_back(static_cast<float>(pose.heading));
    weight.push_back(weight_of_it);
  }
};

/// Gives all particles the same weight.
void weigh_equally(ParticleSet& particles);

/// Returns how many equally weighted particles are worth as much (Kong, Liu & Wong 1994).
double effective_count(const std::vector<double>& weights);

/// Describes where the particles take the robot to be.
struct ParticleEstimate {
  Pose2 chart_from_robot;
  /// Holds the covariance of xi in chart_from_robot * se2_exp(xi), order (x, y, heading), m and rad.
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double share = 0.0;  ///< of the weight that lies in this cluster
};

/// Returns mean and covariance of the heaviest cluster: particles whose cells of `cell_m` and `cell_rad` touch. There
/// is at least one particle.
ParticleEstimate estimate_of(const ParticleSet& particles, double cell_m, double cell_rad);

}  // namespace weft::agents
