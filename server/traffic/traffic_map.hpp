#pragma once
#include <memory>
#include <vector>

#include "core/network/network.hpp"

namespace weft::server {

/// Keeps the network that traffic reckons with: as it is, and as it was when somebody was given a stretch that has
/// been taken out of it since. An edit of the map moves no robot: what was near stays near. Refers to its sources.
class TrafficMap {
 public:
  using History = std::vector<std::shared_ptr<const Snapshot>>;

  TrafficMap(const Snapshot& now) : now_(&now) {}  // NOLINT(google-explicit-constructor): a network alone is map
  TrafficMap(const Snapshot& now, const History& history) : now_(&now), history_(&history) {}

  const Snapshot& now() const { return *now_; }
  /// Returns whether the place is in the network as it is.
  bool is_in(const PlaceId& place) const { return now_->place(place) != nullptr; }
  bool has(const PlaceId& place) const {
    if (is_in(place)) return true;
    if (history_ == nullptr) return false;
    for (const auto& past : *history_) {
      if (past->place(place) != nullptr) return true;
    }
    return false;
  }
  /// Visits the edges at the place; edges that are there still may come several times.
  template <class Visit>
  void for_each_edge(const PlaceId& place, Visit&& visit) const {
    now_->for_each_edge(place, visit);
    if (history_ == nullptr) return;
    for (const auto& past : *history_) past->for_each_edge(place, visit);
  }

 private:
  const Snapshot* now_;
  const History* history_ = nullptr;
};

}  // namespace weft::server
