#include "core/network/page.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace weft {
namespace {

using Shared = std::shared_ptr<const Experience>;

template <class Row>
bool same_ids(const Row& first, const Row& second) {
  const auto same = [](const auto& a, const auto& b) { return a.id == b.id && a.entity_version == b.entity_version; };
  return first.size() == second.size() && std::equal(first.begin(), first.end(), second.begin(), same);
}

/// Compares experiences by what they hold: two readings of one revision are the same, wherever they lie in memory.
bool differ(const Shared& first, const Shared& second) {
  if (first == second) return false;
  return !same_ids(first->places, second->places) || !same_ids(first->chain, second->chain) ||
         !same_ids(first->stitches, second->stitches);
}

/// Tells which experiences pages are made of: all, or with `other` those that differ in the two.
class Selection {
 public:
  explicit Selection(const Snapshot* other) : other_(other) {}
  bool operator()(const ExperienceId& id, const Shared& experience) const {
    if (other_ == nullptr) return true;
    const auto there = other_->experiences().find(id);
    return there == other_->experiences().end() || differ(experience, there->second);
  }

 private:
  const Snapshot* other_;
};

void put_place(const Experience& experience, const Place& place, NetworkPage& page) {
  page.places.push_back(place);
  if (const Edge* const before = place.id.index > 0 ? experience.hop(place.id.index - 1) : nullptr; before != nullptr)
    page.edges.push_back(*before);
  const auto& ends = experience.stitch_ends;
  for (auto at = std::lower_bound(ends.begin(), ends.end(), Experience::StitchEnd{place.id.index, 0});
       at != ends.end() && at->place == place.id.index; ++at) {
    const Edge& stitch = experience.stitches[at->stitch];
    if (stitch.id.b == place.id) page.edges.push_back(stitch);
  }
}

}  // namespace

NetworkPage page_of(const Snapshot& network, const Snapshot* other, const PlaceId& after, std::size_t entities) {
  const Selection is_selected(other);
  NetworkPage page;
  page.revision = network.revision();
  const bool is_first = after == PlaceId{};
  if (is_first) {
    for (const auto& [id, experience] : network.experiences()) {
      if (is_selected(id, experience)) page.total += experience->places.size();
    }
  }
  for (auto at = network.experiences().lower_bound(after.experience); at != network.experiences().end(); ++at) {
    const Experience& experience = *at->second;
    const bool is_begun = !is_first && at->first == after.experience;
    // What an earlier page began with was picked then.
    if (!is_begun && !is_selected(at->first, at->second)) continue;
    const auto behind = [&](const PlaceId& id, const Place& place) { return id < place.id; };
    auto place = is_begun ? std::upper_bound(experience.places.begin(), experience.places.end(), after, behind)
                          : experience.places.begin();
    for (; place != experience.places.end(); ++place) {
      if (page.places.size() + page.edges.size() >= entities) return page;
      put_place(experience, *place, page);
    }
  }
  page.labels = network.labels();
  page.aparts = network.aparts();
  for (const auto& [name, rule] : network.rules()) page.rules.push_back(rule);
  for (const auto& [plan, registration] : network.registrations()) page.registrations.push_back(registration);
  page.is_last = true;
  return page;
}

std::vector<NetworkPage> pieces_of(const NetworkPage& page, std::size_t entities) {
  std::vector<NetworkPage> pieces;
  const auto open = [&] {
    pieces.emplace_back();
    pieces.back().revision = page.revision;
    pieces.back().total = page.total;
    pieces.back().is_last = page.is_last;
  };
  open();
  std::size_t used = 0;
  const auto room = [&]() -> NetworkPage& {
    if (used == entities) {
      open();
      used = 0;
    }
    ++used;
    return pieces.back();
  };
  for (const Place& place : page.places) room().places.push_back(place);
  for (const Edge& edge : page.edges) room().edges.push_back(edge);
  for (const auto& [label, place] : page.labels) room().labels.emplace(label, place);
  for (const Apart& apart : page.aparts) room().aparts.push_back(apart);
  for (const Rule& rule : page.rules) room().rules.push_back(rule);
  for (const Registration& registration : page.registrations) room().registrations.push_back(registration);
  return pieces;
}

Result<void> PagedNetwork::add(NetworkPage page) {
  const bool is_first = window_.revision == Revision{};
  if (!is_first && page.revision != window_.revision) {
    return fail(ErrorCode::stale, "a page of revision " + std::to_string(page.revision.value) +
                                      " among those of revision " + std::to_string(window_.revision.value));
  }
  // The next one would be asked for after the same place, and be the same.
  if (page.places.empty() && !page.is_last) {
    return fail(ErrorCode::invalid, "a page without a place after " + to_string(after()) +
                                        ", and more are to come: is the server of another version?");
  }
  for (const Place& place : page.places) {
    if (!(after() < place.id)) {
      return fail(ErrorCode::invalid, "a page with place " + to_string(place.id) + " after " + to_string(after()));
    }
    window_.places.emplace(place.id, place);
  }
  if (is_first) total_ = page.total;
  window_.revision = page.revision;
  edges_.insert(edges_.end(), std::make_move_iterator(page.edges.begin()), std::make_move_iterator(page.edges.end()));
  window_.labels.merge(page.labels);
  is_whole_ = page.is_last;
  return {};
}

Window PagedNetwork::take() {
  std::sort(edges_.begin(), edges_.end(), [](const Edge& a, const Edge& b) { return a.id < b.id; });
  window_.edges.reserve(edges_.size());
  for (Edge& edge : edges_) {
    const EdgeId id = edge.id;
    if (window_.places.contains(id.a) && window_.places.contains(id.b)) window_.edges.emplace(id, std::move(edge));
  }
  edges_.clear();
  index_edges(window_);
  return std::move(window_);
}

}  // namespace weft
