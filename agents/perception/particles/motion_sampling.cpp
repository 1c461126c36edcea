#include "agents/perception/particles/motion_sampling.hpp"

#include <Eigen/Eigenvalues>

namespace weft::agents {

UncertainMotion operator*(const UncertainMotion& first, const UncertainMotion& then) {
  const Eigen::Matrix3d turn = adjoint(then.previous_from_current.inverse());
  return {first.previous_from_current * then.previous_from_current,
          turn * first.covariance * turn.transpose() + then.covariance};
}

void move(ParticleSet& particles, const UncertainMotion& motion, Random& random) {
  // A root by eigenvalues: the covariance may be of less than full rank.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solved(motion.covariance);
  const Eigen::Vector3d sigmas = solved.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const Eigen::Matrix3d root = solved.eigenvectors() * sigmas.asDiagonal();
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const Eigen::Vector3d drawn(random.normal(), random.normal(), random.normal());
    particles.set(i, particles.pose(i) * motion.previous_from_current * se2_exp(root * drawn));
  }
}

MovedParticles moved_by(const ParticleSet& before, const UncertainMotion& motion, Random& random) {
  ParticleSet expected = before;
  for (std::size_t i = 0; i < before.size(); ++i) expected.set(i, before.pose(i) * motion.previous_from_current);
  MovedParticles moved{expected, expected};
  move(moved.particles, {{}, motion.covariance}, random);
  return moved;
}

void take_to(ParticleSet& particles, const Pose2& new_from_old) {
  for (std::size_t i = 0; i < particles.size(); ++i) particles.set(i, new_from_old * particles.pose(i));
}

}  // namespace weft::agents
