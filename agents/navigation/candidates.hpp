#pragma once
#include <set>
#include <vector>

#include "agents/methods/method.hpp"
#include "agents/navigation/config.hpp"
#include "core/network/window.hpp"

namespace weft::agents {

/// Describes a place that the robot may see from where it is believed to be, with the weak estimate composed along
/// the search.
struct Candidate {
  PlaceId place;
  std::uint32_t depth = 0;    ///< hops from the believed place
  Relation place_from_robot;  ///< predicted
  double cost = 0.0;          ///< predicted norm, lowered for preferred places
};

/// Searches as Gadd & Newman III-C (eq. 6): breadth-first from the believed place, each place with its composed
/// estimate and the map's noise, those within `reach_m` (by norm) ordered by cost, ties by id.
std::vector<Candidate> candidates(const NavigationConfig& config, const Window& window, const Estimate& estimate,
                                  std::uint32_t hops, double reach_m, const std::set<PlaceId>& preferred);

/// Searches likewise but leaves out by distance alone, whichever way the places look, those farther than `reach_m`
/// (none along a path, where no pose is known); in the order of the search.
std::vector<Candidate> at_any_heading(const NavigationConfig& config, const Window& window, const Estimate& estimate,
                                      std::uint32_t hops, double reach_m);

/// Sorts by cost, ties by place.
void sort_by_cost(std::vector<Candidate>& candidates);

/// Return depth (hops) and reach (metres) of the search: near after a fix, growing with what was travelled blind; the
/// depth up to d_max.
std::uint32_t search_hops(const NavigationConfig& config, double blind_m);
double search_reach_m(const NavigationConfig& config, double blind_m);

}  // namespace weft::agents
