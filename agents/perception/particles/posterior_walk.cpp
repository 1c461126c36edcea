#include "agents/perception/particles/posterior_walk.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <utility>

namespace weft::agents {
namespace {

/// Keeps covariances of less than full rank invertible: a millimetre and a milliradian.
Eigen::Matrix3d invertible(const Eigen::Matrix3d& covariance) {
  return covariance + 1e-6 * Eigen::Matrix3d::Identity();
}

}  // namespace

PosteriorWalk::PosteriorWalk(const Eigen::Matrix3d& covariance) : information_(invertible(covariance).inverse()) {}

double PosteriorWalk::log_prior(const Pose2& expected, const Pose2& pose) const {
  const Eigen::Vector3d error = se2_log(expected.inverse() * pose);
  return -0.5 * error.dot(information_ * error);
}

std::vector<float> PosteriorWalk::walk(MovedParticles& moved, const LogLikelihood& log_likelihood,
                                       const Eigen::Matrix3d& spread, int steps, Random& random) const {
  constexpr double widest = 1.374;  // 2.38 by the root of three dimensions
  constexpr int widths = 3;         // each half of the one before: the spread may be that of several peaks
  const Eigen::Matrix3d conditional = (information_ + invertible(spread).inverse()).inverse();
  const Eigen::Matrix3d root = conditional.llt().matrixL();
  ParticleSet& particles = moved.particles;
  std::vector<float> logs = log_likelihood(particles);
  for (int step = 0; step < steps; ++step) {
    const Eigen::Matrix3d reach = widest * std::pow(0.5, step % widths) * root;
    ParticleSet proposed = particles;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const Eigen::Vector3d drawn(random.normal(), random.normal(), random.normal());
      proposed.set(i, particles.pose(i) * se2_exp(reach * drawn));
    }
    const std::vector<float> there = log_likelihood(proposed);
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const Pose2 expected = moved.expected.pose(i);
      const double gain = static_cast<double>(there[i]) - static_cast<double>(logs[i]) +
                          log_prior(expected, proposed.pose(i)) - log_prior(expected, particles.pose(i));
      if (std::log(1.0 - random.uniform()) >= gain) continue;
      particles.set(i, proposed.pose(i));
      logs[i] = there[i];
    }
  }
  return logs;
}

}  // namespace weft::agents
