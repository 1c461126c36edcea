#pragma once
#include <Eigen/Core>

#include "agents/perception/particles/particle_set.hpp"
#include "core/random.hpp"

namespace weft::agents {

/// Describes a motion with the covariance of xi in previous_from_current * se2_exp(xi), order (x, y, heading).
struct UncertainMotion {
  Pose2 previous_from_current;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
};

/// Returns both motions one after the other, their errors independent.
UncertainMotion operator*(const UncertainMotion& first, const UncertainMotion& then);

/// Moves each particle by the motion with an error of its own, drawn from the motion's covariance, which is symmetric
/// positive semi-definite.
void move(ParticleSet& particles, const UncertainMotion& motion, Random& random);

/// Holds particles that were moved, and where each would be had its motion had no error.
struct MovedParticles {
  ParticleSet particles;
  ParticleSet expected;
};
/// Does as move(), and keeps what walking on within the motion's error needs.
MovedParticles moved_by(const ParticleSet& before, const UncertainMotion& motion, Random& random);

/// Takes the particles into another frame: a new chart gets those of the old one.
void take_to(ParticleSet& particles, const Pose2& new_from_old);

}  // namespace weft::agents
