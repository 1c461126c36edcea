#include "server/traffic/layout.hpp"

#include <algorithm>
#include <cmath>

namespace weft::server {
namespace {

bool same_edges(const Edge& a, const Edge& b) {
  return a.id == b.id && identical(a.a_from_b, b.a_from_b);
}

/// Returns whether the same places hang together in the same way; what is known of each place aside.
bool are_alike(const Experience& a, const Experience& b) {
  const auto same_place = [](const Place& one, const Place& other) { return one.id == other.id; };
  return std::ranges::equal(a.places, b.places, same_place) && std::ranges::equal(a.chain, b.chain, same_edges) &&
         std::ranges::equal(a.stitches, b.stitches, same_edges);
}

/// Returns those that are not alike in both.
std::set<ExperienceId> changed(const Snapshot& before, const Snapshot& now) {
  std::set<ExperienceId> ids;
  for (const auto& [id, experience] : before.experiences()) {
    const auto found = now.experiences().find(id);
    const bool is_same =
        found != now.experiences().end() && (found->second == experience || are_alike(*found->second, *experience));
    if (!is_same) ids.insert(id);
  }
  for (const auto& [id, experience] : now.experiences()) {
    if (!before.experiences().contains(id)) ids.insert(id);
  }
  return ids;
}

}  // namespace

void Layout::lay(Network network, std::vector<PlaceId> roots) {
  start(std::move(network), std::move(roots));
  ids_.reserve(network_->place_count());
  branch_of_.reserve(network_->place_count());
  looked_till_ = PlaceId{};
}

void Layout::lay_around(const Network& network, const PlaceId& root, std::size_t most) {
  start(network, {root});
  work(most);
  heap_.clear();
  if (part_ != kNone) end_branches();
  network_.reset();
}

void Layout::start(Network network, std::vector<PlaceId> roots) {
  const double keep_share = keep_share_;
  const std::uint64_t moves = moves_ + 1;
  *this = Layout();
  keep_share_ = keep_share;
  moves_ = moves;
  network_ = std::move(network);
  fresh_.assign(roots.begin(), roots.end());
}

void Layout::joined(Network network, const Batch& batch) {
  network_ = std::move(network);
  for (const Place& place : batch.places) fresh_.push_back(place.id);
  for (const Edge& edge : batch.edges) seeds_.emplace_back(edge.id.a, edge.id.b);
}

void Layout::edited(Network network, const Snapshot& before) {
  const std::set<ExperienceId> touched = changed(before, *network);
  if (touched.empty()) return;
  give_up_branches();
  network_ = std::move(network);
  std::set<Index> parts;
  for (const ExperienceId id : touched) {
    const auto row = rows_.find(id);
    if (row == rows_.end()) continue;
    for (const Index index : row->second) {
      if (index != kNone && places_[index].part != kNone) parts.insert(places_[index].part);
    }
  }
  take_out(parts);
  for (const ExperienceId id : touched) {
    const auto row = rows_.find(id);
    if (row == rows_.end()) continue;
    for (std::uint32_t at = 0; at < row->second.size(); ++at) {
      if (network_->place({id, at}) == nullptr) forget({id, at});
    }
  }
  looked_till_ = PlaceId{};
}

void Layout::take_out(const std::set<Index>& parts) {
  if (parts.empty()) return;
  ++moves_;
  for (Laid& place : places_) {
    if (place.part != kNone && parts.contains(place.part)) place = Laid{};
  }
  for (const Index part : parts) {
    if (parts_.at(part).is_ready) laid_ -= parts_.at(part).places;
    parts_.erase(part);
  }
}

Layout::Index Layout::find(const PlaceId& place) const {
  const auto row = rows_.find(place.experience);
  return row == rows_.end() || place.index >= row->second.size() ? kNone : row->second[place.index];
}

Layout::Index Layout::find_or_add(const PlaceId& place) {
  std::vector<Index>& row = rows_[place.experience];
  if (row.empty()) row.reserve(network_->experience(place.experience)->extent);
  if (place.index >= row.size()) row.resize(place.index + 1, kNone);
  Index& index = row[place.index];
  if (index != kNone) return index;
  if (!free_.empty()) {
    index = free_.back();
    free_.pop_back();
    ids_[index] = place;
    return index;
  }
  index = static_cast<Index>(places_.size());
  places_.emplace_back();
  ids_.push_back(place);
  branch_of_.push_back(kNone);
  return index;
}

void Layout::forget(const PlaceId& place) {
  const Index index = find(place);
  if (index == kNone) return;
  places_[index] = Laid{};
  free_.push_back(index);
  rows_.at(place.experience)[place.index] = kNone;
}

std::optional<std::uint32_t> Layout::part_of(const PlaceId& place) const {
  const Index index = find(place);
  const Index part = index == kNone ? kNone : places_[index].part;
  if (part == kNone || !parts_.at(part).is_ready) return std::nullopt;
  return part;
}

std::optional<Spot> Layout::spot(const PlaceId& place) const {
  if (!part_of(place)) return std::nullopt;
  const Index index = find(place);
  const Laid& laid = places_[index];
  return Spot{.at = index,
              .part = laid.part,
              .part_from_place = laid.part_from_place,
              .spread = laid.spread,
              .sigma_m = largest_sigma_m(laid.spread.at(laid.part_from_place.translation())),
              .bend = share_of_bend(laid.spread.heading_variance_rad2())};
}

Spot Layout::hung(const Spot& place, const Metric2& place_from_it) const {
  Spot spot = place;
  spot.part_from_place = place.part_from_place * place_from_it.a_from_b;
  const Eigen::Matrix3d turned = adjoint(spot.part_from_place);
  spot.spread = Spread(place.spread.matrix() + turned * place_from_it.covariance * turned.transpose());
  spot.sigma_m = largest_sigma_m(spot.spread.at(spot.part_from_place.translation()));
  spot.bend = share_of_bend(spot.spread.heading_variance_rad2());
  return spot;
}

double Layout::distance_m(const Spot& a, const Spot& b) {
  return (a.part_from_place.translation() - b.part_from_place.translation()).norm();
}

/// Returns the nearest common ancestor. Two ancestors of one depth have their jumps at one depth, too.
Layout::Index Layout::common(Index a, Index b) const {
  if (places_[a].depth < places_[b].depth) std::swap(a, b);
  const Index depth = places_[b].depth;
  while (places_[a].depth > depth) {
    const Index jump = places_[a].jump;
    a = places_[jump].depth >= depth ? jump : places_[a].parent;
  }
  while (a != b) {
    const bool is_above = places_[a].jump == places_[b].jump;
    a = is_above ? places_[a].parent : places_[a].jump;
    b = is_above ? places_[b].parent : places_[b].jump;
  }
  return a;
}

double Layout::clearance_m(const Spot& a, const Spot& b) const {
  const Spread before = is_laid(a) && is_laid(b) ? places_[common(a.at, b.at)].spread : Spread{};
  const Spread of_a = a.spread.since(before);
  const Spread of_b = b.spread.since(before);
  const Eigen::Vector2d at_a = a.part_from_place.translation();
  const Eigen::Vector2d at_b = b.part_from_place.translation();
  return least_distance_m(at_a - at_b, of_a.at(at_a) + of_b.at(at_b),
                          share_of_bend(of_a.heading_variance_rad2() + of_b.heading_variance_rad2()));
}

bool Layout::are_near(const Spot& a, const Spot& b, double reach_m) const {
  if (a.part != b.part) return false;
  const double most_m = kLayoutSigmas * std::hypot(a.sigma_m, b.sigma_m) * (1.0 + std::min(1.0, a.bend + b.bend));
  if (distance_m(a, b) - most_m > reach_m) return false;
  return clearance_m(a, b) <= reach_m;
}

std::vector<PlaceId> Layout::roots() const {
  std::vector<PlaceId> roots;
  for (const auto& [part, known] : parts_) {
    if (known.is_ready) roots.push_back(ids_[part]);
  }
  return roots;
}

}  // namespace weft::server
