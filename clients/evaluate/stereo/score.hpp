#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "clients/evaluate/stereo/follow.hpp"

namespace weft::evaluate::stereo {

/// Holds how well a path fits the truth.
struct PathScore {
  std::size_t seen = 0;   ///< steps
  double ate_m = 0.0;     ///< RMS of positions, laid over the truth; of a robot at rest, from where it began
  double end_m = 0.0;     ///< how far the last position is off, both laid together at the start
  double step_mm = 0.0;   ///< RMS of a step's translation
  double step_deg = 0.0;  ///< RMS of a step's turn
  double ms = 0.0;        ///< of the processor, a pair
};

/// Holds both methods' scores at one rate.
struct RateRow {
  std::size_t every = 1;
  double hz = 0.0;
  std::size_t pairs = 0;  ///< with a truth
  double way_m = 0.0;     ///< by the truth
  PathScore ours;
  PathScore baseline;

  bool is_at_rest() const { return way_m < kRestM; }
  static constexpr double kRestM = 0.1;
};

/// Holds the positions of all that a picture shows, in the frame of the truth.
struct Laid {
  std::vector<Eigen::Vector3d> truth;
  std::vector<Eigen::Vector3d> ours;
  std::vector<Eigen::Vector3d> baseline;
};

/// Holds a row, and the paths that it is of.
struct Scored {
  RateRow row;
  Laid laid;
};
/// Scores what was followed where the truth is known. Paths are laid over it by rotation and translation with the
/// least squares (Umeyama 1991), without scale; those of a robot at rest at their start. None: it is known for
/// fewer than five pairs.
std::optional<Scored> score(const Followed& followed, std::size_t every, const formats::Trajectory& truth);

}  // namespace weft::evaluate::stereo
