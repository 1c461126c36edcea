#include "agents/navigation/own_map.hpp"

#include <algorithm>

namespace weft::agents {

namespace {

bool is_of(const Window& window, std::string_view method) {
  return std::all_of(window.places.begin(), window.places.end(),
                     [&](const auto& entry) { return entry.second.method == method; });
}

Window part_of(const Window& window, std::string_view method) {
  Window part;
  part.revision = window.revision;
  for (const auto& [id, place] : window.places) {
    if (place.method == method) part.places.emplace(id, place);
  }
  for (const auto& [label, id] : window.labels) {
    if (part.place(id) != nullptr) part.labels.emplace(label, id);
  }
  for (const auto& [id, edge] : window.edges) {
    if (part.place(id.a) != nullptr && part.place(id.b) != nullptr) part.edges.emplace(id, edge);
  }
  index_edges(part);
  return part;
}

void insert(Window& window, const std::vector<Edge>& edges) {
  for (const Edge& edge : edges) {
    if (window.place(edge.id.a) == nullptr || window.place(edge.id.b) == nullptr) continue;
    window.edges.emplace(edge.id, edge);
  }
  index_edges(window);
}

}  // namespace

void OwnMap::clear() {
  *this = OwnMap(method_);
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

void OwnMap::part_from_others(const Window& window) {
  std::erase_if(edges_, [](const Edge& edge) { return edge.id.a.experience != edge.id.b.experience; });
  if (joined_) join(window);
}

bool OwnMap::has(const PlaceId& place) const {
  return std::any_of(places_.begin(), places_.end(), [&](const Place& own) { return own.id == place; });
}

void OwnMap::update(const Window& window, std::uint64_t generation, bool done) {
  if (done && !places_.empty() && window.place(places_.back().id) != nullptr) clear();
  const Seen now{window.revision, generation};
  if (now == seen_ && (joined_ || places_.empty())) return;
  seen_ = now;
  join(window);
}

OwnMap OwnMap::over(const Window& window) const {
  OwnMap other = *this;
  other.seen_.reset();
  other.join(window);
  return other;
}

void OwnMap::join(const Window& window) {
  joined_.reset();
  if (!is_of(window, method_)) joined_ = part_of(window, method_);
  if (places_.empty()) return;
  if (!joined_) joined_ = window;
  for (const Place& place : places_) joined_->places.emplace(place.id, place);
  insert(*joined_, edges_);
}

}  // namespace weft::agents
