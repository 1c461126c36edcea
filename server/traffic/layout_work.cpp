#include <algorithm>
#include <limits>

#include "core/network/search.hpp"
#include "server/traffic/layout.hpp"

/// Makes a layout and keeps it up: Dijkstra's search from the root of a part, or from where something was added.
namespace weft::server {
namespace {

/// States how much faster what has been laid out is passed over than something is laid out.
constexpr std::size_t kPassedAtOnce = 16;

}  // namespace

bool Layout::work(std::size_t places) {
  bool has_news = false;
  while (network_ != nullptr && places > 0) has_news = piece(places) || has_news;
  return has_news;
}

/// Does one bounded piece. Returns true when everything that can be asked for now is done.
bool Layout::piece(std::size_t& places) {
  if (part_ == kNone) {
    if (!begin_branches() && !begin_part(places)) network_.reset();
    return false;
  }
  if (heap_.empty()) {
    end_branches();
    return true;
  }
  std::pop_heap(heap_.begin(), heap_.end());
  const Way way = heap_.back();
  heap_.pop_back();
  --places;
  hang(way);
  return false;
}

const Layout::Laid& Layout::now(Index index) const {
  const Index branch = branch_of_[index];
  return branch == kNone ? places_[index] : branches_[branch].second;
}

std::uint64_t Layout::size_of(Index part) const {
  const auto found = parts_.find(part);
  return found == parts_.end() ? 0 : found->second.places;
}

Layout::Index Layout::larger(Index a, Index b) const {
  if (a == kNone || b == kNone) return a == kNone ? b : a;
  if (size_of(a) != size_of(b)) return size_of(a) > size_of(b) ? a : b;
  return std::min(a, b);
}

/// Joins parts over edges that were added since: one part at a time, and of two that they join the larger one takes
/// the other over.
bool Layout::begin_branches() {
  const auto part_at = [this](const PlaceId& place) {
    const Index index = find(place);
    return index == kNone ? kNone : places_[index].part;
  };
  const auto part_of = [&](const Seed& seed) { return larger(part_at(seed.first), part_at(seed.second)); };
  // What lies between places that are not laid out is come by when one of them is.
  std::erase_if(seeds_, [&](const Seed& seed) { return part_of(seed) == kNone; });
  if (seeds_.empty()) return false;
  part_ = part_of(seeds_.front());
  is_new_ = false;
  const auto others =
      std::stable_partition(seeds_.begin(), seeds_.end(), [&](const Seed& seed) { return part_of(seed) == part_; });
  under_way_.assign(seeds_.begin(), others);
  seeds_.erase(seeds_.begin(), others);
  for (const Seed& seed : under_way_) push_edge(seed);
  return true;
}

bool Layout::begin_part(std::size_t& places) {
  for (; !fresh_.empty(); fresh_.pop_front()) {
    if (begin_part_at(fresh_.front())) return true;
  }
  if (!looked_till_) return false;
  const auto& experiences = network_->experiences();
  std::size_t room = places * kPassedAtOnce;
  for (auto at = experiences.lower_bound(looked_till_->experience); at != experiences.end(); ++at) {
    const std::uint32_t first = at->first == looked_till_->experience ? looked_till_->index : 0;
    for (std::uint32_t index = first; index < at->second->extent; ++index, --room) {
      looked_till_ = PlaceId{at->first, index};
      if (room == 0) {
        places = 0;
        return true;
      }
      if (begin_part_at(*looked_till_)) return true;
    }
  }
  looked_till_.reset();
  return false;
}

bool Layout::begin_part_at(const PlaceId& place) {
  const Index known = find(place);
  if (known != kNone && places_[known].part != kNone) return false;
  if (network_->place(place) == nullptr) return false;
  part_ = find_or_add(place);
  is_new_ = true;
  parts_[part_] = {};
  put(part_, {.part_from_place = {}, .spread = {}, .parent = part_, .jump = part_, .depth = 0, .part = part_});
  network_->for_each_edge(place, [&](const Edge& edge) { push_edge({place, other_end(edge, place)}); });
  return true;
}

void Layout::push(Index on, Index place, double uncertainty) {
  heap_.push_back({.uncertainty = uncertainty, .place = place, .on = on});
  std::push_heap(heap_.begin(), heap_.end());
}

/// Offers both ways of the edge; what gains nothing is left where it is.
void Layout::push_edge(const Seed& seed) {
  for (const auto& [from, to] : {seed, Seed{seed.second, seed.first}}) {
    const Index on = find(from);
    if (on == kNone || !is_of_part(on) || network_->place(to) == nullptr) continue;
    const Index place = find_or_add(to);
    network_->for_each_edge(from, [&](const Edge& edge) {
      if (other_end(edge, from) == to) push(on, place, now(on).uncertainty + uncertainty_of(edge));
    });
  }
}

/// Returns how the place lies when it hangs on another by their least uncertain edge; none: no edge joins them.
std::optional<Layout::Laid> Layout::laid_on(Index index, Index on_index) const {
  const PlaceId& on = ids_[on_index];
  const Edge* least = nullptr;
  double uncertainty = 0.0;
  network_->for_each_edge(on, [&](const Edge& edge) {
    if (other_end(edge, on) != ids_[index]) return;
    const double of_edge = uncertainty_of(edge);
    if (least != nullptr && of_edge >= uncertainty) return;
    least = &edge;
    uncertainty = of_edge;
  });
  if (least == nullptr) return std::nullopt;
  const Laid& parent = now(on_index);
  const Laid& above = now(parent.jump);
  const Metric2 on_from_place = laid_flat(relation_from(*least, on));
  Laid laid;
  laid.part_from_place = parent.part_from_place * on_from_place.a_from_b;
  const Eigen::Matrix3d turned = adjoint(laid.part_from_place);
  laid.spread = Spread(parent.spread.matrix() + turned * on_from_place.covariance * turned.transpose());
  laid.uncertainty = parent.uncertainty + uncertainty;
  laid.parent = on_index;
  laid.depth = parent.depth + 1;
  laid.jump = parent.depth - above.depth == above.depth - now(above.jump).depth ? above.jump : on_index;
  laid.part = part_;
  return laid;
}

/// Hangs a place on another. A place whose parent was hung anew is hung anew with it.
void Layout::hang(const Way& way) {
  if (way.place == part_ || !is_of_part(way.on)) return;
  const Laid before = now(way.place);
  const bool is_ours = before.part == part_;
  const bool follows = is_ours && before.parent == way.on;
  const double worth = is_ours && !follows ? before.uncertainty * keep_share_ : std::numeric_limits<double>::max();
  if (way.uncertainty >= worth) return;
  const std::optional<Laid> laid = laid_on(way.place, way.on);
  if (!laid || laid->uncertainty >= worth || (follows && *laid == before)) return;
  put(way.place, *laid);
  const PlaceId id = ids_[way.place];
  network_->for_each_edge(id, [&](const Edge& edge) { reach(way.place, edge); });
}

/// Looks over an edge from a place that was hung just now.
void Layout::reach(Index from, const Edge& edge) {
  const PlaceId other = other_end(edge, ids_[from]);
  Index place = find(other);
  if (place == kNone) {
    if (network_->place(other) == nullptr) return;
    place = find_or_add(other);
  }
  const Laid& known = now(place);
  const double uncertainty = now(from).uncertainty + uncertainty_of(edge);
  if (known.part == kNone) return push(from, place, uncertainty);
  if (known.part == part_) {
    const bool follows = known.parent == from && place != part_;
    if (follows || uncertainty < known.uncertainty * keep_share_) push(from, place, uncertainty);
    return;
  }
  if (!is_new_ && larger(known.part, part_) == part_) return push(from, place, uncertainty);
  seeds_.emplace_back(ids_[from], other);
}

void Layout::put(Index index, const Laid& laid) {
  if (is_new_) {
    if (places_[index].part != part_) ++parts_.at(part_).places;
    places_[index] = laid;
    return;
  }
  Index& branch = branch_of_[index];
  if (branch == kNone) {
    branch = static_cast<Index>(branches_.size());
    branches_.emplace_back(index, laid);
  } else {
    branches_[branch].second = laid;
  }
}

void Layout::end_branches() {
  if (is_new_) {
    parts_.at(part_).is_ready = true;
    laid_ += parts_.at(part_).places;
  }
  for (const auto& [index, laid] : branches_) {
    const Index before = places_[index].part;
    if (before != kNone) ++moves_;
    places_[index] = laid;
    branch_of_[index] = kNone;
    if (before == part_) continue;
    ++parts_.at(part_).places;
    if (before == kNone) {
      ++laid_;
    } else if (--parts_.at(before).places == 0) {
      parts_.erase(before);
    }
  }
  branches_.clear();
  under_way_.clear();
  part_ = kNone;
}

void Layout::give_up_branches() {
  if (part_ == kNone) return;
  for (const auto& [index, laid] : branches_) branch_of_[index] = kNone;
  branches_.clear();
  heap_.clear();
  seeds_.insert(seeds_.end(), under_way_.begin(), under_way_.end());
  under_way_.clear();
  if (is_new_) take_out({part_});
  part_ = kNone;
}

}  // namespace weft::server
