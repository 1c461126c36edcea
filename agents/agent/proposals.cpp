#include "agents/agent/proposals.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "core/network/search.hpp"

namespace weft::agents {
namespace {

constexpr std::uint32_t kAroundHops = 3;     ///< of a suspected place: enough to confirm it
constexpr std::uint32_t kAroundPlaces = 50;  ///< where many robots have driven

/// Returns all contents, those of `first` before the others, each once.
std::vector<ContentRef> contents_of_first(const std::vector<PlaceId>& first, const Window& window,
                                          const std::vector<ContentRef>& others) {
  std::vector<ContentRef> all;
  all.reserve(others.size());
  std::set<ContentHash> taken;
  const auto take = [&](const ContentRef& content) {
    if (taken.insert(content.hash).second) all.push_back(content);
  };
  for (const PlaceId& id : first) {
    if (const Place* const place = window.place(id); place != nullptr) take(place->content);
  }
  std::for_each(others.begin(), others.end(), take);
  return all;
}

}  // namespace

void Proposals::forget() {
  places_.clear();
  noted_.clear();
}

bool Proposals::is_news(const std::string& note) {
  return std::exchange(noted_, note) != note;
}

bool Proposals::suspect(const std::optional<PlaceId>& place) {
  return std::exchange(suspected_, place) != place;
}

std::vector<PlaceId> Proposals::always_held(const std::optional<Route>& route) const {
  std::vector<PlaceId> held = route.has_value() ? route->places : std::vector<PlaceId>{};
  held.insert(held.end(), places_.begin(), places_.end());
  return held;
}

WindowDefinition Proposals::usual(WindowDefinition present, const std::optional<Route>& route) const {
  if (is_alone_) {
    present.centre.reset();
    present.hops = usual_.hops;
    present.cap = usual_.cap;
  }
  present.route = always_held(route);
  return present;
}

WindowDefinition Proposals::wanted(WindowDefinition present, const std::optional<Route>& route, const Held& held) {
  WindowDefinition definition = usual(std::move(present), route);
  const bool holds_all = !definition.centre.has_value() && !is_alone_ && held.places < usual_.cap;
  is_alone_ = !places_.empty() && !holds_all && !held.knows_something;
  if (is_alone_) {
    definition.centre = suspected_.has_value() ? *suspected_ : places_.front();
    definition.hops = kAroundHops;
    definition.cap = static_cast<std::uint32_t>(definition.route.size()) + kAroundPlaces;
  }
  return definition;
}

std::vector<ContentRef> Proposals::put_first(std::vector<ContentRef> contents, const Window& window) const {
  if (places_.empty()) return contents;
  std::vector<PlaceId> first;
  if (suspected_.has_value()) first = neighbourhood(window, *suspected_, kAroundHops, kAroundPlaces);
  first.insert(first.end(), places_.begin(), places_.end());
  return contents_of_first(first, window, contents);
}

}  // namespace weft::agents
