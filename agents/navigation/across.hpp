#pragma once
#include <array>
#include <limits>
#include <vector>

#include "agents/navigation/candidates.hpp"
#include "agents/navigation/config.hpp"

namespace weft::agents {

/// Describes a method whose contents show a piece of floor: `gaze` is its middle, in the robot's frame. Two places
/// see the same floor where the middles meet, whichever way the robots looked.
template <class M>
concept Gazes = Method<M> && requires(const M& m, const typename M::Content& content) {
  { m.gaze(content) } -> std::same_as<Eigen::Vector2d>;
};

/// Chooses the places that a kept one is held against although the robot cannot change over to them: those of lanes
/// that it meets head-on or across. One stitch for each direction every `across_every_m` says where such a lane lies.
/// A value.
class Across {
 public:
  explicit Across(const StitchConfig& config) : config_(config) {}

  /// Returns, for each direction (a quarter of a turn) that is due, the place whose middle is predicted nearest to
  /// the robot's, nearest first; at most three. `around` and `driven_m` are of the kept place.
  std::vector<Candidate> worth_comparing(const std::vector<Candidate>& around, const Eigen::Vector2d& gaze_in_robot,
                                         double driven_m) const;
  void joined(const Relation& place_from_kept, double driven_m);

 private:
  static constexpr std::size_t kDirections = 4;  ///< quarters of a turn; the first one is the robot's own

  StitchConfig config_;
  std::array<double, kDirections> joined_at_m_ = {
      -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
      -std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};

}  // namespace weft::agents
