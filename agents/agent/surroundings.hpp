#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "agents/navigation/map_view.hpp"
#include "core/network/goal.hpp"
#include "core/network/network.hpp"
#include "core/network/window.hpp"

namespace weft::agents {

/// Returns the window's contents in the order in which the robot needs them: its route from `route_at` on, then
/// outwards from `focus` by hops, then the rest by id. No repeats, and none of places that none of `methods` can
/// read.
std::vector<ContentRef> nearest_first(const Window& window, const std::vector<std::string>& methods,
                                      const std::optional<PlaceId>& focus, const std::optional<Route>& route,
                                      std::uint32_t route_at);

/// Returns whether the window reaches `hops` around `place` with all contents that one of `methods` reads: enough to
/// look for oneself there.
bool is_covered(const MapView& map, const std::vector<std::string>& methods, const PlaceId& place,
                std::uint32_t hops);

/// Returns whether the next `count` places of the route from `at` on are there with their contents.
bool is_covered(const MapView& map, const Route& route, std::uint32_t at, std::uint32_t count);

/// Returns whether `place` is within `hops` of `centre` in the window.
bool is_near(const Window& window, const PlaceId& centre, const PlaceId& place, std::uint32_t hops);

/// Returns goal_from_robot through the relations of the window; none where they do not join.
std::optional<Relation> seen_from(const Window& window, const PlaceId& goal, const PlaceId& place,
                                  const Relation& place_from_robot);

}  // namespace weft::agents
