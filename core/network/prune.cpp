#include "core/network/prune.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <queue>
#include <utility>

#include "core/network/search.hpp"

namespace weft {
namespace {

constexpr std::size_t kPlacesAStep = 64;
constexpr std::size_t kLookedAround = 96;       ///< most places seen in the search for a cover
constexpr std::size_t kLookedForWays = 20'000;  ///< most places seen in the search for a way round
constexpr double kLonger = 1.5;
constexpr double kLonger_m = 2.0;

using Ways = std::map<PlaceId, double>;

/// Returns the lengths of the shortest ways from `from` over edges of the method, no longer than `most_m`. A way
/// enters only places that `passes` lets through; others that it comes to are in the result, and are its ends.
template <class Passes>
Ways ways(const Snapshot& snapshot, const PlaceId& from, const std::string& method, double most_m, Passes&& passes) {
  using Open = std::pair<double, PlaceId>;
  Ways found = {{from, 0.0}};
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  open.push({0.0, from});
  while (!open.empty() && found.size() < kLookedForWays) {
    const auto [length_m, here] = open.top();
    open.pop();
    if (length_m > found.at(here) || (here != from && !passes(here))) continue;
    snapshot.for_each_edge(here, [&](const Edge& edge) {
      if (edge.method != method || !can_drive(edge, here)) return;
      const double next_m = length_m + distance_m(edge.a_from_b);
      if (next_m > most_m) return;
      const PlaceId next = other_end(edge, here);
      const auto [at, is_new] = found.emplace(next, next_m);
      if (!is_new && at->second <= next_m) return;
      at->second = next_m;
      open.push({next_m, next});
    });
  }
  return found;
}

bool is_in(const Stretch& run, const PlaceId& place) {
  return place.experience == run.experience && run.first <= place.index && place.index <= run.last;
}

std::vector<ExperienceId> least_stitched_first(const Snapshot& snapshot) {
  std::vector<std::pair<double, ExperienceId>> order;
  for (const auto& [id, experience] : snapshot.experiences()) {
    if (experience->places.empty()) continue;
    order.emplace_back(
        static_cast<double>(experience->stitches.size()) / static_cast<double>(experience->places.size()), id);
  }
  std::sort(order.begin(), order.end());
  std::vector<ExperienceId> ids;
  for (const auto& [stitches, id] : order) ids.push_back(id);
  return ids;
}

}  // namespace

Pruner::Pruner(Snapshot snapshot, PruneRule rule)
    : snapshot_(std::move(snapshot)), rule_(std::move(rule)), order_(least_stitched_first(snapshot_)) {
  for (const auto& [label, place] : snapshot_.labels()) rule_.keep.insert(place);
  if (rule_.by) std::erase(order_, *rule_.by);
  for (const ExperienceId id : order_) total_ += snapshot_.experience(id)->places.size();
}

bool Pruner::step() {
  if (!runs_.empty()) {
    const Stretch run = runs_.back();
    runs_.pop_back();
    if (!is_missed(run)) {
      found_.places.push_back(run);
      for (std::uint32_t index = run.first; index <= run.last; ++index) gone_.insert({run.experience, index});
    } else {
      try_around_a_junction(run);
    }
    return true;
  }
  if (current_ != nullptr && next_place_ < current_->places.size()) {
    look_at_places();
    return true;
  }
  if (next_experience_ == order_.size()) return false;
  current_ = snapshot_.experience(order_[next_experience_++]);
  next_place_ = 0;
  covers_.assign(current_->places.size(), {});
  return true;
}

/// Splits a run that cannot go as a whole: a stitched place in its middle stays as a junction, and what lies to
/// either side of it is queued to be tried.
void Pruner::try_around_a_junction(const Stretch& run) {
  const auto& ends = snapshot_.experience(run.experience)->stitch_ends;
  const auto first = std::lower_bound(ends.begin(), ends.end(), Experience::StitchEnd{run.first, 0});
  const auto last = std::lower_bound(first, ends.end(), Experience::StitchEnd{run.last + 1, 0});
  if (first == last) return;
  const std::uint32_t junction = (first + (last - first) / 2)->place;
  if (junction < run.last) runs_.push_back({run.experience, junction + 1, run.last});
  if (junction > run.first) runs_.push_back({run.experience, run.first, junction - 1});
}

/// Finds what covers the next places of the experience; after the last one queues the runs of covered places to be
/// tried.
void Pruner::look_at_places() {
  const std::size_t end = std::min(next_place_ + kPlacesAStep, current_->places.size());
  for (; next_place_ < end; ++next_place_) {
    const Place& place = current_->places[next_place_];
    ++done_;
    if (rule_.keep.contains(place.id) || covering_.contains(place.id)) continue;
    covers_[next_place_] = cover_of(place);
  }
  if (next_place_ < current_->places.size()) return;
  for (std::size_t at = 0; at < covers_.size(); ++at) {
    if (!covers_[at].is_covered) continue;
    const std::uint32_t index = current_->places[at].id.index;
    covering_.insert(covers_[at].by);
    const bool goes_on = !runs_.empty() && runs_.back().last + 1 == index;
    if (goes_on) {
      runs_.back().last = index;
    } else {
      runs_.push_back({current_->id, index, index});
    }
  }
  std::reverse(runs_.begin(), runs_.end());
}

/// Finds the nearest place that covers this one, over composed relations.
Pruner::Cover Pruner::cover_of(const Place& place) const {
  struct Open {
    PlaceId place;
    Pose2 place_from_here;
  };
  Cover best;
  double best_m = rule_.within_m;
  std::set<PlaceId> seen = {place.id};
  std::deque<Open> open = {{place.id, {}}};
  while (!open.empty() && seen.size() < kLookedAround) {
    const Open here = open.front();
    open.pop_front();
    snapshot_.for_each_edge(here.place, [&](const Edge& edge) {
      const PlaceId next = other_end(edge, here.place);
      if (!stays(next) || !seen.insert(next).second) return;
      const Pose2 pose = here.place_from_here * planar(relation_from(edge, here.place));
      const double away_m = pose.translation().norm();
      if (away_m > 3 * rule_.within_m + 1.0) return;
      open.push_back({next, pose});
      const bool may_cover = rule_.by ? next.experience == *rule_.by : next.experience != place.id.experience;
      const bool covers = may_cover && away_m <= best_m && std::abs(wrap_angle(pose.heading)) <= rule_.within_rad;
      if (!covers || snapshot_.place(next)->method != place.method) return;
      best = {true, next};
      best_m = away_m;
    });
  }
  return best;
}

/// Returns whether somebody could drive through the run from one place around it to another, but not without it.
bool Pruner::is_missed(const Stretch& run) const {
  const Experience& experience = *snapshot_.experience(run.experience);
  const std::string& method = experience.method;
  std::set<PlaceId> around;
  double length_m = 0.0;
  for (std::uint32_t index = run.first; index <= run.last; ++index) {
    snapshot_.for_each_edge({run.experience, index}, [&](const Edge& edge) {
      length_m += distance_m(edge.a_from_b);
      for (const PlaceId& end : {edge.id.a, edge.id.b}) {
        if (!is_in(run, end) && stays(end)) around.insert(end);
      }
    });
  }
  for (const PlaceId& from : around) {
    const Ways through = ways(snapshot_, from, method, length_m, [&](const PlaceId& at) { return is_in(run, at); });
    double most_m = 0.0;
    for (const auto& [to, way_m] : through) {
      if (around.contains(to)) most_m = std::max(most_m, way_m);
    }
    const Ways left = ways(snapshot_, from, method, kLonger * most_m + kLonger_m,
                           [&](const PlaceId& at) { return !is_in(run, at) && stays(at); });
    for (const auto& [to, way_m] : through) {
      if (!around.contains(to)) continue;
      const auto still = left.find(to);
      if (still == left.end() || still->second > kLonger * way_m + kLonger_m) return true;
    }
  }
  return false;
}

namespace {

std::size_t edges_at(const Snapshot& snapshot, const PlaceId& place) {
  std::size_t edges = 0;
  snapshot.for_each_edge(place, [&](const Edge&) { ++edges; });
  return edges;
}

}  // namespace

Removal still_unneeded(const Pruner& pruner, const Snapshot& now, const std::set<PlaceId>& keep) {
  Removal left = pruner.found();
  std::erase_if(left.places, [&](const Stretch& run) {
    for (std::uint32_t index = run.first; index <= run.last; ++index) {
      const PlaceId place{run.experience, index};
      const bool is_as_it_was = now.place(place) != nullptr && !keep.contains(place) &&
                                edges_at(now, place) == edges_at(pruner.snapshot(), place);
      const bool has_label = std::any_of(now.labels().begin(), now.labels().end(),
                                         [&](const auto& label) { return label.second == place; });
      if (!is_as_it_was || has_label) return true;
    }
    return false;
  });
  return present(now, left);
}

bool only_grew(const Snapshot& before, const Snapshot& now) {
  return std::all_of(before.experiences().begin(), before.experiences().end(), [&](const auto& entry) {
    const Experience* const after = now.experience(entry.first);
    if (after == entry.second.get()) return true;
    return after != nullptr && after->places.size() >= entry.second->places.size() &&
           after->stitches.size() >= entry.second->stitches.size() &&
           std::includes(after->places.begin(), after->places.end(), entry.second->places.begin(),
                         entry.second->places.end(), [](const Place& a, const Place& b) { return a.id < b.id; });
  });
}

std::uint64_t content_bytes(const Snapshot& snapshot, const Removal& removal) {
  std::uint64_t bytes = 0;
  for (const Stretch& run : removal.places) {
    for (std::uint32_t index = run.first; index <= run.last; ++index) {
      const Place* const place = snapshot.place({run.experience, index});
      if (place != nullptr) bytes += place->content.size;
    }
  }
  return bytes;
}

}  // namespace weft
