#pragma once
#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "agents/perception/particles/likelihood_field.hpp"
#include "agents/perception/particles/motion_sampling.hpp"
#include "agents/perception/particles/posterior_walk.hpp"
#include "agents/perception/particles/resampling.hpp"
#include "core/random.hpp"

namespace weft::agents {

/// Bounds how a scan is blurred that tells far more than the motion did, so that few of the particles are near
/// enough.
struct BlurConfig {
  /// Blurs a scan that would leave a smaller effective share of the particles: its beams become twice as wide, up to
  /// `most` times. [0, 1)
  double least_effective = 0.05;
  int most = 3;     ///< [0, 6]
  int seeking = 2;  ///< as many at least while particles are drawn from anywhere; [0, most]
  int steps = 6;    ///< that particles walk at each width on the way back to the scan as it is; [0, 50]
};

/// Describes where something else than the scan sees the robot.
struct ToldPose {
  Pose2 chart_from_robot;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Identity();  ///< of xi in chart_from_robot * se2_exp(xi)
  double stray = 1e-3;  ///< likelihood left far off from it, over that at its middle: it may be wrong; (0, 1)
};

/// Tells how a scan counted.
struct ScanWeight {
  /// Is the geometric mean of a beam's likelihood over the scan, mean over the particles weighed; (0, 1]. 0: there
  /// was no beam.
  double likelihood = 0.0;
  double power = 0.0;  ///< with which the scan counted in the end
  int blurs = 0;       ///< how many times beams became twice as wide at first
};

/// Weighs particles by one scan, from coarse to fine (annealing as Deutscher, Blake & Reid 2000 do it): where too few
/// are near the truth it is blurred first; the particles are resampled, walk by what the blurred scan tells and the
/// motion did, and are weighed by half the blur, down to none. What comes is distributed as the motion and the scan
/// alone have it, and not blurred.
class ScanWeighing {
 public:
  /// `ends` has one at least, unless a pose is told. `covariance` is that of the motion since the scan before. What
  /// is told weighs with the scan, and is blurred with it.
  ScanWeighing(const BlurConfig& config, const KldConfig& cells, const LikelihoodField& field,
               std::vector<BeamEnd> ends, const Eigen::Matrix3d& covariance,
               const std::optional<ToldPose>& told = std::nullopt);

  /// Weighs the particles, beginning with so many blurs at least.
  ScanWeight weigh(MovedParticles& moved, int least_blurs, Random& random);

 private:
  /// Returns what the beams alone say, as much as they are worth.
  std::vector<float> logs_of_beams(const ParticleSet& particles) const;
  std::vector<float> logs_of(const ParticleSet& particles) const;
  double likelihood_of(const ParticleSet& particles) const;
  /// Makes beams wider until enough particles count; returns how many times.
  int blur(const ParticleSet& particles, int least_blurs);
  /// Resamples, walks by the width in use, to a power, and weighs by the one before; returns the power of that.
  double sharpen(MovedParticles& moved, double power, Random& random);
  /// Weighs by likelihoods to the largest power that leaves enough particles; returns the power.
  double weigh_by(ParticleSet& particles, std::span<const float> logs) const;

  BlurConfig config_;
  KldConfig cells_;
  const LikelihoodField& field_;
  std::vector<std::vector<BeamEnd>> widths_;  ///< of the beams, the one in use last
  PosteriorWalk walk_;
  std::optional<ToldPose> told_;
  Eigen::Matrix3d told_information_ = Eigen::Matrix3d::Zero();
  std::vector<float> logs_;  ///< of the particles, by the width in use
};

/// Returns the largest power up to `most` by which likelihoods may be raised so that the weights are worth at least
/// `least` particles; `logs` are those of the likelihoods, weighted as the particles were before.
double tempered_power(const std::vector<double>& before, std::span<const float> logs, double most, double least);

}  // namespace weft::agents
