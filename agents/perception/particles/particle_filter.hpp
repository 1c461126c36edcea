#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "agents/perception/particles/likelihood_field.hpp"
#include "agents/perception/particles/motion_sampling.hpp"
#include "agents/perception/particles/resampling.hpp"
#include "agents/perception/particles/scan_weighing.hpp"
#include "core/random.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Bounds how a filter notices that it follows a wrong place (augmented Monte Carlo localisation: Thrun, Burgard &
/// Fox 2005, table 8.3).
struct RecoveryConfig {
  double slow = 0.01;     ///< share of a new likelihood in the long mean; (0, fast)
  double fast = 0.1;      ///< share in the short mean; (0, 1]
  double patience = 1.3;  ///< the short mean times this must fall below the long one; [1, 10] (Gutmann & Fox 2002)
};

struct ParticleFilterConfig {
  KldConfig kld;
  LikelihoodConfig likelihood;
  RecoveryConfig recovery;
  BlurConfig blur;
  double update_m = 0.1;          ///< moved by so much, it is due (Dayoub et al. 2013, IV-B); [0, 10]
  double update_rad = 0.0087266;  ///< or turned by so much; [0, pi]
  double resample_below = 0.5;    ///< effective share of the particles; (0, 1]
};
/// Returns every bound that does not hold, each error naming field, value and bound.
std::vector<Error> check(const ParticleFilterConfig& config);

/// Tells what an update did.
struct ParticleUpdate {
  ScanWeight scan;        ///< of power 0: nothing returned, it did not count
  double injected = 0.0;  ///< share of the particles that were drawn anew, from anywhere
};

/// Localises in a grid by scans and motions: Monte Carlo localisation with a number of particles that adapts. A
/// value; the same seed and the same input give the same particles.
class ParticleFilter {
 public:
  /// The configuration has passed check().
  ParticleFilter(const ParticleFilterConfig& config, std::uint64_t seed);

  /// Begins about a pose; `covariance` as in UncertainMotion. All particles are there until the first update.
  void begin_at(const Pose2& chart_from_robot, const Eigen::Matrix3d& covariance, std::size_t count);
  /// Begins anywhere.
  void begin_anywhere(const DrawPose& anywhere, std::size_t count);
  /// Goes on in another chart with the same particles, so that nothing of the belief is lost.
  void carry_to(const Pose2& new_from_old);

  void advance(const UncertainMotion& motion) { pending_ = pending_ * motion; }
  /// Returns whether enough was moved since the last update, or there was none.
  bool is_due() const;
  /// Moves the particles and weighs them by a scan; resamples when few are left that count. `anywhere` draws what is
  /// injected when the filter seems to follow a wrong place; empty: nothing is. `told` weighs beside the scan.
  ParticleUpdate update(const LikelihoodField& field, const Scan& scan, const DrawPose& anywhere,
                        const std::optional<ToldPose>& told = std::nullopt);

  /// Returns where the robot is now: the estimate of the last update and what was moved since.
  ParticleEstimate estimate() const;
  const ParticleSet& particles() const { return particles_; }

 private:
  void settle();
  /// Returns the particles moved, more of them where that spreads them so far (Fox 2001 counts after the motion).
  MovedParticles predict(const UncertainMotion& motion);
  /// Resamples where few particles are left that count, or some are to be drawn from anywhere.
  void renew(ParticleUpdate& update, const DrawPose& anywhere);
  /// Draws a share of the particles from anywhere. One that was drawn stands for its cell, and so may be as far off.
  void seek(double share, const DrawPose& anywhere);
  double injected_share(double likelihood);

  ParticleFilterConfig config_;
  Random random_;
  ParticleSet particles_;
  UncertainMotion pending_;
  ParticleEstimate estimate_;
  double slow_ = 0.0;  ///< long mean of the likelihood; 0: none yet
  double fast_ = 0.0;
  bool is_new_ = true;
  bool is_seeking_ = false;  ///< particles were injected at the last update
};

}  // namespace weft::agents
