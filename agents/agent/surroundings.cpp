#include "agents/agent/surroundings.hpp"

#include <algorithm>

#include "core/network/search.hpp"

namespace weft::agents {
namespace {
constexpr std::uint32_t kArrivalHops = 12;

bool has_content(const MapView& map, const PlaceId& id) {
  const Place* const place = map.window.place(id);
  return place != nullptr && map.contents.find(place->content.hash) != nullptr;
}

bool can_read(const std::vector<std::string>& methods, const Place& place) {
  return std::find(methods.begin(), methods.end(), place.method) != methods.end();
}
}  // namespace

std::vector<ContentRef> nearest_first(const Window& window, const std::vector<std::string>& methods,
                                      const std::optional<PlaceId>& focus, const std::optional<Route>& route,
                                      std::uint32_t route_at) {
  std::vector<ContentRef> contents;
  contents.reserve(window.places.size());
  std::vector<bool> taken(window.places.size(), false);
  const auto take_at = [&](std::size_t position) {
    if (position >= taken.size() || taken[position]) return;
    taken[position] = true;
    const Place& place = window.places.value_at(position);
    if (can_read(methods, place)) contents.push_back(place.content);
  };
  const auto take = [&](const PlaceId& id) { take_at(window.places.position(id)); };
  if (route.has_value()) {
    for (std::size_t i = route_at; i < route->places.size(); ++i) take(route->places[i]);
  }
  if (focus.has_value()) {
    const auto all = static_cast<std::uint32_t>(window.places.size());
    for (const PlaceId& id : neighbourhood(window, *focus, all, all)) take(id);
  }
  for (std::size_t position = 0; position < taken.size(); ++position) take_at(position);
  return contents;
}

bool is_covered(const MapView& map, const std::vector<std::string>& methods, const PlaceId& place,
                std::uint32_t hops) {
  const auto all = static_cast<std::uint32_t>(map.window.places.size());
  const std::vector<PlaceId> around = neighbourhood(map.window, place, hops, all);
  return !around.empty() && std::all_of(around.begin(), around.end(), [&](const PlaceId& id) {
    return has_content(map, id) || !can_read(methods, *map.window.place(id));
  });
}

bool is_covered(const MapView& map, const Route& route, std::uint32_t at, std::uint32_t count) {
  const std::size_t end = std::min<std::size_t>(route.places.size(), static_cast<std::size_t>(at) + count);
  for (std::size_t i = at; i < end; ++i) {
    if (!has_content(map, route.places[i])) return false;
  }
  return true;
}

bool is_near(const Window& window, const PlaceId& centre, const PlaceId& place, std::uint32_t hops) {
  const auto all = static_cast<std::uint32_t>(window.places.size());
  const std::vector<PlaceId> around = neighbourhood(window, centre, hops, all);
  return std::find(around.begin(), around.end(), place) != around.end();
}

std::optional<Relation> seen_from(const Window& window, const PlaceId& goal, const PlaceId& place,
                                  const Relation& place_from_robot) {
  const auto all = static_cast<std::uint32_t>(window.places.size());
  for (const Reached& reached : breadth_first(window, goal, kArrivalHops, all)) {
    if (reached.id == place) return compose(reached.centre_from_place, place_from_robot);
  }
  return std::nullopt;
}

}  // namespace weft::agents
