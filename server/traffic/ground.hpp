#pragma once
#include <memory>
#include <vector>

#include "core/network/network.hpp"

namespace weft::server {

/// The network that traffic reckons with: as it is, and as it was when somebody was given a stretch that has been
/// taken out of it since. An edit of the map moves no robot: what was near stays near. Refers to what it is made of.
class Ground {
 public:
  using Pasts = std::vector<std::shared_ptr<const Snapshot>>;

  Ground(const Snapshot& now) : now_(&now) {}  // NOLINT(google-explicit-constructor): a network alone is ground
  Ground(const Snapshot& now, const Pasts& pasts) : now_(&now), pasts_(&pasts) {}

  const Snapshot& now() const { return *now_; }
  /// Whether it is in the network as it is.
  bool is_in(const PlaceId& place) const { return now_->place(place) != nullptr; }
  bool has(const PlaceId& place) const {
    if (is_in(place)) return true;
    if (pasts_ == nullptr) return false;
    for (const auto& past : *pasts_) {
      if (past->place(place) != nullptr) return true;
    }
    return false;
  }
  /// Edges that are there still may come several times.
  template <class Visit>
  void for_each_edge(const PlaceId& place, Visit&& visit) const {
    now_->for_each_edge(place, visit);
    if (pasts_ == nullptr) return;
    for (const auto& past : *pasts_) past->for_each_edge(place, visit);
  }

 private:
  const Snapshot* now_;
  const Pasts* pasts_ = nullptr;
};

}  // namespace weft::server
