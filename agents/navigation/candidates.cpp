#include "agents/navigation/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "agents/navigation/belief.hpp"
#include "core/network/search.hpp"

namespace weft::agents {

namespace {

/// Returns whether a place is certainly farther than `reach_m`, by the plane alone: most of a large map is, and costs
/// little to leave out. False along a path, where no pose is known.
bool is_beyond(const Reached& reached, const Relation& centre_from_robot, double reach_m) {
  const bool metric = !std::holds_alternative<AlongPath>(reached.centre_from_place) &&
                      !std::holds_alternative<AlongPath>(centre_from_robot);
  constexpr double rounding_m = 1e-6;
  return metric &&
         (planar(reached.centre_from_place).translation() - planar(centre_from_robot).translation()).norm() >
             reach_m + rounding_m;
}

}  // namespace

std::vector<Candidate> at_any_heading(const NavigationConfig& config, const Window& window, const Estimate& estimate,
                                      std::uint32_t hops, double reach_m) {
  constexpr std::uint32_t cap = 2000;
  std::vector<Candidate> found;
  for (const Reached& reached : breadth_first(window, estimate.place, hops, cap)) {
    if (is_beyond(reached, estimate.place_from_robot, reach_m)) continue;
    const double edges = std::sqrt(static_cast<double>(reached.depth));
    const Relation believed_from_place =
        with_noise(reached.centre_from_place, edges * config.belief.map_sigma_m, edges * config.belief.map_sigma_rad);
    found.push_back(
        {reached.id, reached.depth, compose(inverse(believed_from_place), estimate.place_from_robot), 0.0});
    found.back().cost = norm(found.back().place_from_robot);
  }
  return found;
}

std::vector<Candidate> candidates(const NavigationConfig& config, const Window& window, const Estimate& estimate,
                                  std::uint32_t hops, double reach_m, const std::set<PlaceId>& preferred) {
  std::vector<Candidate> found = at_any_heading(config, window, estimate, hops, reach_m);
  std::erase_if(found, [&](const Candidate& candidate) { return candidate.cost > reach_m; });
  for (Candidate& candidate : found) {
    if (preferred.contains(candidate.place)) candidate.cost *= config.locate.route_preference;
  }
  sort_by_cost(found);
  return found;
}

void sort_by_cost(std::vector<Candidate>& candidates) {
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tie(a.cost, a.place) < std::tie(b.cost, b.place);
  });
}

std::uint32_t search_hops(const NavigationConfig& config, double blind_m) {
  constexpr double slack = 1.5;  // places may lie closer than the spacing where the robot turned
  const double blind_hops = slack * blind_m / config.teach.spacing_m;
  const double hops = config.locate.near_hops + std::min(blind_hops, 1000.0);
  return std::min(static_cast<std::uint32_t>(hops), std::max(config.locate.most_hops, config.locate.near_hops));
}

double search_reach_m(const NavigationConfig& config, double blind_m) {
  return config.locate.reach_m + config.locate.reach_share * blind_m;
}

}  // namespace weft::agents
