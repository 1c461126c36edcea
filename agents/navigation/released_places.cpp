#include "agents/navigation/released_places.hpp"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>

#include "agents/navigation/spots.hpp"

namespace weft::agents {
namespace {

/// Returns at which share of a hop from `a` it passes nearest to the origin.
double share_at_origin(const Eigen::Vector2d& a, const Eigen::Vector2d& hop) {
  return std::clamp(-a.dot(hop) / hop.squaredNorm(), 0.0, 1.0);
}

}  // namespace

PathAhead released_places(const Route& route, const RouteAround& around) {
  const std::vector<RoutePose>& poses = around.poses;
  std::optional<Spot> spot = next_spot(around);
  // A corner is no end for it: it finds its own way round.
  if (spot && spot->first == spot->last) spot.reset();
  const std::size_t end = spot ? spot->first : poses.size() - 1;
  std::size_t first = std::min(around.nearest, end);
  if (first > 0 && !on_the_spot(poses[first - 1], poses[first])) --first;
  PathAhead ahead;
  for (std::size_t i = first; i <= end; ++i) ahead.robot_from_path.push_back(poses[i].robot_from_place);
  const auto last = std::min(route.released, static_cast<std::uint32_t>(route.places.size() - 1));
  ahead.reaches_end = spot || poses[end].index == last;
  if (spot) {
    ahead.turn_to_rad = heading_on(poses[spot->last]);
    ahead.turn_reaches = poses[spot->last].index;
  }
  return ahead;
}

double away_from_way_m(const RouteAround& around) {
  const std::vector<RoutePose>& poses = around.poses;
  const Eigen::Vector2d here = poses[around.nearest].robot_from_place.translation();
  double away_m = here.norm();
  for (const std::size_t other : {around.nearest - 1, around.nearest + 1}) {
    if (other >= poses.size()) continue;  // before the first one, too
    const Eigen::Vector2d hop = poses[other].robot_from_place.translation() - here;
    if (hop.norm() > 0.0) away_m = std::min(away_m, (here + share_at_origin(here, hop) * hop).norm());
  }
  return away_m;
}

double way_left_m(const std::vector<Pose2>& robot_from_path) {
  double nearest_m = std::numeric_limits<double>::infinity();
  double left_m = 0.0;
  for (std::size_t i = 0; i + 1 < robot_from_path.size(); ++i) {
    const Eigen::Vector2d a = robot_from_path[i].translation();
    const Eigen::Vector2d hop = robot_from_path[i + 1].translation() - a;
    const double length_m = hop.norm();
    if (length_m <= 0.0) continue;
    const double share = share_at_origin(a, hop);
    const double away_m = (a + share * hop).norm();
    if (away_m < nearest_m) {
      nearest_m = away_m;
      left_m = (1.0 - share) * length_m;
    } else {
      left_m += length_m;
    }
  }
  return left_m;
}

}  // namespace weft::agents
