#include "agents/navigation/own_map.hpp"

#include <algorithm>

namespace weft::agents {

namespace {

void insert(Window& window, const std::vector<Edge>& edges) {
  for (const Edge& edge : edges) {
    if (window.place(edge.id.a) == nullptr || window.place(edge.id.b) == nullptr) continue;
    window.edges.emplace(edge.id, edge);
  }
  index_edges(window);
}

}  // namespace

void OwnMap::clear() {
  *this = OwnMap{};
}

void OwnMap::add(const Place& place, const std::vector<Edge>& edges) {
  places_.push_back(place);
  edges_.insert(edges_.end(), edges.begin(), edges.end());
  if (!joined_) return;
  joined_->places.emplace(place.id, place);
  insert(*joined_, edges);
}

void OwnMap::anchor(const Edge& edge) {
  edges_.push_back(edge);
  if (joined_) insert(*joined_, {edge});
}

bool OwnMap::has(const PlaceId& place) const {
  return std::any_of(places_.begin(), places_.end(), [&](const Place& own) { return own.id == place; });
}

void OwnMap::update(const Window& window, bool done) {
  if (places_.empty()) return;
  if (done && window.place(places_.back().id) != nullptr) return clear();
  const Seen now{window.revision, window.places.size(), window.edges.size()};
  if (joined_ && now == seen_) return;
  seen_ = now;
  join(window);
}

void OwnMap::join(const Window& window) {
  joined_ = window;
  for (const Place& place : places_) joined_->places.emplace(place.id, place);
  insert(*joined_, edges_);
}

}  // namespace weft::agents
