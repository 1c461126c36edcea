#pragma once
#include <Eigen/Core>
#include <functional>
#include <vector>

#include "agents/perception/particles/motion_sampling.hpp"
#include "agents/perception/particles/particle_set.hpp"
#include "core/random.hpp"

namespace weft::agents {

/// Returns the log-likelihood of each particle, by which it is to be weighed.
using LogLikelihood = std::function<std::vector<float>(const ParticleSet& particles)>;

/// Walks moved particles at random so that they stay distributed as they are told: by the error of their motion,
/// times a likelihood (resample-move: Gilks & Berzuini 2001; steps by Metropolis, as wide as Gelman, Roberts & Gilks
/// 1996 have it). So those that resampling has made equal part again, and get nearer to the truth than any was drawn.
class PosteriorWalk {
 public:
  /// `covariance` is that of the motion, which brought the particles where they are.
  explicit PosteriorWalk(const Eigen::Matrix3d& covariance);

  /// Takes `steps` steps; `spread` is the covariance of the particles where they are densest, all of the same weight.
  /// Returns the log-likelihoods where they are then.
  std::vector<float> walk(MovedParticles& moved, const LogLikelihood& log_likelihood, const Eigen::Matrix3d& spread,
                          int steps, Random& random) const;

 private:
  /// Returns the logarithm of how probable a motion to a pose was, but for a constant.
  double log_prior(const Pose2& expected, const Pose2& pose) const;

  Eigen::Matrix3d information_;
};

}  // namespace weft::agents
