#include "server/traffic/plan/distances.hpp"

#include <algorithm>

namespace weft::server {

Distances::Distances(BerthGraph& graph, Berth to, std::uint32_t methods, const std::vector<Berth>& occupied)
    : graph_(graph), to_(to), methods_(methods), occupied_(occupied) {
  reach(to, 0.0);
}

double Distances::more_m(Berth berth) const {
  return std::binary_search(occupied_.begin(), occupied_.end(), berth) ? kOccupied_m : 0.0;
}

double Distances::over_next_m(Berth berth) {
  double least_m = kFar_m;
  for (const BerthArc& arc : graph_.next(berth, methods_)) {
    if (is_stop(arc.to)) least_m = std::min(least_m, over_m(arc));
  }
  return least_m;
}

void Distances::reach(Berth berth, double distance_m) {
  if (berth >= reached_m_.size()) {
    const std::size_t size = std::max<std::size_t>(graph_.size(), berth + std::size_t{1});
    reached_m_.resize(size, kFar_m);
    is_settled_.resize(size, false);
  }
  if (distance_m >= reached_m_[berth]) return;
  reached_m_[berth] = distance_m;
  open_.emplace(distance_m, berth);
}

double Distances::from_m(Berth berth) {
  if (!is_stop(berth)) return over_next_m(berth);
  while (!is_settled(berth)) {
    if (open_.empty()) return kFar_m;
    settle_next();
  }
  return reached_m_[berth];
}

void Distances::settle_next() {
  const auto [distance_m, here] = open_.top();
  open_.pop();
  if (is_settled_[here]) return;
  is_settled_[here] = true;
  for (const BerthGraph::Before& before : graph_.before(here, methods_)) {
    reach(before.from, distance_m + before.length_m + more_m(here));
  }
}

/// Searches until the berth is settled, or nothing is left to be searched or of `left`.
bool Distances::settle(Berth berth, std::size_t& left) {
  while (!is_settled(berth) && !open_.empty()) {
    if (left == 0) return false;
    --left;
    settle_next();
  }
  return true;
}

bool Distances::search(Berth berth, std::size_t most) {
  if (is_stop(berth)) return settle(berth, most);
  const std::vector<BerthArc>& next = graph_.next(berth, methods_);
  return std::all_of(next.begin(), next.end(),
                     [&](const BerthArc& arc) { return !is_stop(arc.to) || settle(arc.to, most); });
}

Berth Distances::leads_over(const std::function<bool(Berth)>& is_one, Berth from) {
  if (from_m(from) < kOccupied_m) return kNoBerth;
  while (from != to_) {
    const BerthArc* best = nullptr;
    double best_m = from_m(from);
    for (const BerthArc& arc : graph_.next(from, methods_)) {
      const double rest_m = more_m(arc.to) + from_m(arc.to);
      if (rest_m >= best_m || !is_stop(arc.to)) continue;
      best = &arc;
      best_m = rest_m;
    }
    if (best == nullptr) return kNoBerth;
    if (is_one(best->to)) return best->to;
    from = best->to;
  }
  return kNoBerth;
}

}  // namespace weft::server
