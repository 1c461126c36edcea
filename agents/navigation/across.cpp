#include "agents/navigation/across.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>

#include "agents/navigation/agreement.hpp"

namespace weft::agents {
namespace {

/// Returns how far the robot is turned against the place, in quarters of a turn: 0, about as it is; 1 to 3, more.
std::size_t direction_of(const Relation& place_from_robot) {
  constexpr double quarter = std::numbers::pi / 2.0;
  const long turns = std::lround(wrap_angle(planar(place_from_robot).heading) / quarter);
  return static_cast<std::size_t>((turns + 4) % 4);
}

}  // namespace

std::vector<Candidate> Across::worth_comparing(const std::vector<Candidate>& around,
                                               const Eigen::Vector2d& gaze_in_robot, double driven_m) const {
  std::array<std::optional<Candidate>, kDirections> best;
  for (Candidate candidate : around) {
    const std::size_t direction = direction_of(candidate.place_from_robot);
    if (direction == 0 || driven_m - joined_at_m_[direction] < config_.across_every_m) continue;
    constexpr double sigmas = 3.0;
    candidate.cost = (planar(candidate.place_from_robot) * gaze_in_robot - gaze_in_robot).norm();
    const double reach_m = config_.reach_m + sigmas * spread_of(candidate.place_from_robot).metres;
    if (candidate.cost > std::min(reach_m, config_.most_reach_m)) continue;
    std::optional<Candidate>& known = best[direction];
    if (!known || std::tie(candidate.cost, candidate.place) < std::tie(known->cost, known->place)) known = candidate;
  }
  std::vector<Candidate> chosen;
  for (const std::optional<Candidate>& candidate : best) {
    if (candidate) chosen.push_back(*candidate);
  }
  sort_by_cost(chosen);
  return chosen;
}

void Across::joined(const Relation& place_from_kept, double driven_m) {
  joined_at_m_[direction_of(place_from_kept)] = driven_m;
}

}  // namespace weft::agents
