#pragma once
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "agents/perception/clouds/ndt.hpp"
#include "clients/evaluate/registration/stereo_run.hpp"

namespace weft::evaluate::registration {

inline constexpr double kDegrees = 180.0 / std::numbers::pi;  ///< in a radian

/// Describes how far a registration is off: along the run, across it, and turned.
struct Off {
  double along_m = 0.0;
  double across_m = 0.0;
  double heading_rad = 0.0;

  double metres() const;
};
Off off(const Pose3& truth, const Pose3& estimated);

/// Holds one registration of two places.
struct Trial {
  Off before;           ///< of what it began with
  Off after;            ///< the same as before, when it was refused
  std::string refused;  ///< empty: it was not
  double nees = 0.0;  ///< squared error in the covariance that it stated, 6 degrees of freedom; of those not refused
  int from_prior = 0;
};

/// Describes what is known of an edge by odometry: in the plane, and of what stays level.
struct EdgePrior {
  double sigma_m = 0.03;
  double sigma_rad = 0.0105;  // 0.6 degrees
  double level_sigma_m = 0.01;
  double level_sigma_rad = 0.005;

  Matrix6d covariance() const;
};

/// Registers the places of one run, each with the next, 0.5 m on, given the truth disturbed by the prior's own
/// errors.
std::vector<Trial> edge_trials(SceneKind kind, std::uint64_t seed, const EdgePrior& prior,
                               const agents::NdtConfig& config);

/// Describes how far off the guesses are that stitches begin from.
struct StitchGuess {
  double sigma_m = 0.15;
  double sigma_rad = 0.05;
};

/// Registers the places of a second run, beside the first and turned, with the nearest of the first, from a guess of
/// which nothing is known.
std::vector<Trial> stitch_trials(SceneKind kind, std::uint64_t seed, const StitchGuess& guess,
                                 const agents::NdtConfig& config);

}  // namespace weft::evaluate::registration
