#include "storage/network_builder.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "core/network/index_of.hpp"

namespace weft::storage {
namespace {

/// Sorts by index; of equal ones the last added stays.
template <class Row>
void sort_latest(std::vector<Row>& rows) {
  const auto is_before = [](const Row& left, const Row& right) { return index_of(left) < index_of(right); };
  if (!std::is_sorted(rows.begin(), rows.end(), is_before)) std::stable_sort(rows.begin(), rows.end(), is_before);
  const auto is_same = [](const Row& left, const Row& right) { return index_of(left) == index_of(right); };
  const auto kept = std::unique(rows.rbegin(), rows.rend(), is_same);
  rows.erase(rows.begin(), kept.base());
}

/// Writes ranges of indices as text: "3, 7 to 9".
std::string ranges(const std::vector<std::uint32_t>& sorted) {
  std::string text;
  for (std::size_t first = 0; first < sorted.size();) {
    std::size_t last = first;
    while (last + 1 < sorted.size() && sorted[last + 1] == sorted[last] + 1) ++last;
    text += (text.empty() ? "" : ", ") + std::to_string(sorted[first]);
    if (last > first) text += " to " + std::to_string(sorted[last]);
    first = last + 1;
  }
  return text;
}

bool is_served(const std::map<ExperienceId, Experience>& experiences, const PlaceId& id) {
  const auto found = experiences.find(id.experience);
  return found != experiences.end() && found->second.place(id.index) != nullptr;
}

std::string name_of(const EdgeId& id) {
  return to_string(id.a) + " - " + to_string(id.b);
}

}  // namespace

void NetworkBuilder::add(Head head) {
  rows_[head.id].head = std::move(head);
}

void NetworkBuilder::add(Place place) {
  rows_[place.id.experience].places.push_back(std::move(place));
}

void NetworkBuilder::add(Edge edge, Revision since) {
  if (edge.origin == Origin::stitch) {
    stitches_.push_back({std::make_shared<const Edge>(std::move(edge)), since});
  } else {
    rows_[edge.id.a.experience].chain.push_back(std::move(edge));
  }
}

void NetworkBuilder::add_label(const std::string& label, const PlaceId& place) {
  if (place.experience) {
    labels_[label] = place;
  } else {
    labels_.erase(label);
  }
}

void NetworkBuilder::add_apart(const Apart& apart, bool holds) {
  if (holds) {
    aparts_.insert(apart);
  } else {
    aparts_.erase(apart);
  }
}

void NetworkBuilder::add_rule(const Rule& rule, bool holds) {
  if (holds) {
    rules_.insert_or_assign(rule.name, rule);
  } else {
    rules_.erase(rule.name);
  }
}

void NetworkBuilder::add_registration(const Registration& registration, bool holds) {
  if (holds) {
    registrations_.insert_or_assign(registration.plan, registration);
  } else {
    registrations_.erase(registration.plan);
  }
}

void NetworkBuilder::add_damage(std::string what) {
  damage_.push_back(std::move(what));
}

void NetworkBuilder::add_damaged(const PlaceId& place, const std::string& why) {
  add_absent(place);
  damaged_places_.insert(place);
  add_damage("place " + to_string(place) + ": " + why);
}

void NetworkBuilder::add_absent(const PlaceId& place) {
  rows_[place.experience].absent_places.push_back(place.index);
}

void NetworkBuilder::add_absent(const EdgeId& edge) {
  if (is_hop(edge)) rows_[edge.a.experience].absent_hops.push_back(edge.a.index);
}

void NetworkBuilder::move(const Removal& removal, bool is_back, Revision at) {
  for (const Stretch& stretch : removal.places) {
    rows_[stretch.experience].moves.push_back({stretch.first, stretch.last, is_back});
  }
  for (const EdgeId& stitch : removal.stitches) {
    if (is_back) {
      stitches_out_.erase(stitch);
    } else {
      stitches_out_[stitch] = at;
    }
  }
}

void NetworkBuilder::add_deleted(const Stretch& stretch) {
  rows_[stretch.experience].deleted.push_back(stretch);
}

/// Returns one more than the highest index of a row, and names rows that are missing. The number of places in the
/// experience's own row has no checksum, so it alone makes nothing large.
std::uint32_t NetworkBuilder::measure(const Rows& rows) {
  const std::uint64_t counted = rows.head.places;
  std::uint64_t seen = rows.places.empty() ? 0 : std::uint64_t{rows.places.back().id.index} + 1;
  for (const std::uint32_t index : rows.absent_places) {
    seen = std::max(seen, std::min<std::uint64_t>(std::uint64_t{index} + 1, counted));
  }
  for (const Stretch& stretch : rows.deleted) {
    seen = std::max(seen, std::min<std::uint64_t>(std::uint64_t{stretch.last} + 1, counted));
  }
  seen = std::min<std::uint64_t>(seen, std::numeric_limits<std::uint32_t>::max());
  const std::string experience = "experience " + to_string(rows.head.id);
  if (counted > std::numeric_limits<std::uint32_t>::max()) {
    damage_.push_back(experience + ": its row says " + std::to_string(counted) + " places, which no run has; " +
                      std::to_string(seen) + " are there");
  } else if (seen < counted) {
    damage_.push_back(experience + ": the rows of places " + std::to_string(seen) +
                      (seen + 1 < counted ? " to " + std::to_string(counted - 1) : "") + " are missing");
  } else if (seen > counted) {
    damage_.push_back(experience + ": its row says " + std::to_string(counted) + " places, " + std::to_string(seen) +
                      " are there");
  }
  return static_cast<std::uint32_t>(seen);
}

/// Leaves what is part of the map; names what should be there and is not.
void NetworkBuilder::thin(Rows& rows, std::uint32_t extent) {
  std::vector<bool> out(extent);
  for (const Move& move : rows.moves) {
    for (std::uint64_t i = move.first; i <= move.last && i < extent; ++i) out[i] = !move.is_back;
  }
  for (const Stretch& stretch : rows.deleted) {
    for (std::uint64_t i = stretch.first; i <= stretch.last && i < extent; ++i) out[i] = true;
  }
  std::erase_if(rows.places, [&](const Place& place) { return place.id.index >= extent || out[place.id.index]; });

  std::vector<bool> there(extent);
  for (const Place& place : rows.places) there[place.id.index] = true;
  std::erase_if(rows.chain, [&](const Edge& hop) {
    return hop.id.b.index >= extent || !there[hop.id.a.index] || !there[hop.id.b.index];
  });
  name_missing(rows, out, there);
  if (std::ranges::find(out, true) != out.end()) out_[rows.head.id] = std::move(out);
}

void NetworkBuilder::name_missing(const Rows& rows, const std::vector<bool>& out, const std::vector<bool>& there) {
  const auto extent = static_cast<std::uint32_t>(there.size());
  std::vector<bool> absent(extent);
  for (const std::uint32_t index : rows.absent_places) {
    if (index < extent) absent[index] = true;
  }
  std::vector<std::uint32_t> missing;
  for (std::uint32_t i = 0; i < extent; ++i) {
    if (!out[i] && !there[i] && !absent[i]) missing.push_back(i);
  }
  const std::string experience = "experience " + to_string(rows.head.id);
  if (!missing.empty()) damage_.push_back(experience + ": the rows of places " + ranges(missing) + " are missing");

  std::vector<bool> hops(extent);
  for (const Edge& hop : rows.chain) hops[hop.id.a.index] = true;
  for (const std::uint32_t index : rows.absent_hops) {
    if (index < extent) hops[index] = true;
  }
  missing.clear();
  for (std::uint32_t i = 0; i + 1 < extent; ++i) {
    if (there[i] && there[i + 1] && !hops[i]) missing.push_back(i);
  }
  if (!missing.empty()) {
    damage_.push_back(experience + ": the rows of the edges after places " + ranges(missing) + " are missing");
  }
}

Experience NetworkBuilder::assemble(Rows& rows) {
  sort_latest(rows.places);
  sort_latest(rows.chain);
  const std::uint32_t extent = measure(rows);
  thin(rows, extent);
  Experience experience;
  experience.id = rows.head.id;
  experience.robot = rows.head.robot;
  experience.name = std::move(rows.head.name);
  experience.method = std::move(rows.head.method);
  experience.sealed = rows.head.sealed;
  experience.seal_reason = std::move(rows.head.seal_reason);
  experience.extent = extent;
  experience.places = SharedRow<Place>(std::exchange(rows.places, {}));
  experience.chain = SharedRow<Edge>(std::exchange(rows.chain, {}));
  return experience;
}

bool NetworkBuilder::is_out(const PlaceId& place) const {
  const auto experience = out_.find(place.experience);
  return experience != out_.end() && place.index < experience->second.size() && experience->second[place.index];
}

bool NetworkBuilder::is_left_behind(const PlaceId& place) const {
  const auto rows = rows_.find(place.experience);
  if (rows == rows_.end() || damaged_places_.contains(place)) return false;
  const std::vector<std::uint32_t>& absent = rows->second.absent_places;
  return std::ranges::find(absent, place.index) != absent.end();
}

bool NetworkBuilder::is_out(const EdgeId& stitch, Revision since) const {
  const auto taken = stitches_out_.find(stitch);
  return (taken != stitches_out_.end() && since <= taken->second) || is_out(stitch.a) || is_out(stitch.b);
}

/// Adds the experiences of `rest` that have, or had, stitches to those that were added; without these stitches.
void NetworkBuilder::borrow_neighbours(const Snapshot& rest, std::map<ExperienceId, Experience>& experiences) const {
  std::set<ExperienceId> neighbours;
  const auto note = [&](const Edge& stitch) { neighbours.insert({stitch.id.a.experience, stitch.id.b.experience}); };
  for (const auto& [id, experience] : experiences) {
    const Experience* const before = rest.experience(id);
    if (before != nullptr) std::ranges::for_each(before->stitches, note);
  }
  for (const Stitch& stitch : stitches_) note(*stitch.edge);
  for (const ExperienceId id : neighbours) {
    const Experience* const known = rows_.contains(id) ? nullptr : rest.experience(id);
    if (known == nullptr) continue;
    Experience& neighbour = experiences.emplace(id, *known).first->second;
    neighbour.stitches.erase_if([this](const Edge& stitch) {
      return rows_.contains(stitch.id.a.experience) || rows_.contains(stitch.id.b.experience);
    });
  }
}

void NetworkBuilder::join_stitches(std::map<ExperienceId, Experience>& experiences) {
  std::stable_sort(stitches_.begin(), stitches_.end(),
                   [](const Stitch& left, const Stitch& right) { return left.edge->id < right.edge->id; });
  for (std::size_t at = 0; at < stitches_.size(); ++at) {
    const auto& [stitch, since] = stitches_[at];
    const EdgeId id = stitch->id;
    if (at + 1 < stitches_.size() && stitches_[at + 1].edge->id == id) continue;  // replaced
    if (is_out(id, since)) continue;
    if (!is_served(experiences, id.a) || !is_served(experiences, id.b)) {
      damage_.push_back("stitch " + name_of(id) + ": one of its places is not served");
      continue;
    }
    experiences.at(id.a.experience).stitches.push_back(stitch);
    if (id.b.experience != id.a.experience) experiences.at(id.b.experience).stitches.push_back(stitch);
  }
  stitches_ = {};
  for (auto& [id, experience] : experiences) {
    experience.stitches.shrink_to_fit();
    index_stitches(experience);
  }
}

Snapshot NetworkBuilder::build(Revision revision, const Snapshot& rest) {
  std::map<ExperienceId, Experience> experiences;
  for (auto& [id, rows] : rows_) {
    if (!rows.head.id) {
      damage_.push_back("experience " + to_string(id) + ": its row is missing; it is not served");
      continue;
    }
    experiences.emplace_hint(experiences.end(), id, assemble(rows));
  }
  borrow_neighbours(rest, experiences);
  join_stitches(experiences);

  Snapshot::Experiences shared = rest.experiences();
  for (auto& [id, experience] : experiences) {
    shared[id] = std::make_shared<const Experience>(std::move(experience));
  }
  const Snapshot network(revision, std::move(shared), rest.shared_labels());
  return {revision,
          network.experiences(),
          labels_of(network),
          aparts_of(network),
          std::make_shared<const Snapshot::Rules>(rules_),
          std::make_shared<const Snapshot::Registrations>(registrations_)};
}

std::shared_ptr<const Snapshot::Aparts> NetworkBuilder::aparts_of(const Snapshot& network) const {
  auto aparts = std::make_shared<Snapshot::Aparts>();
  std::ranges::copy_if(aparts_, std::back_inserter(*aparts),
                       [&](const Apart& apart) { return weft::is_served(network, apart); });
  return aparts;
}

std::shared_ptr<const Snapshot::Labels> NetworkBuilder::labels_of(const Snapshot& network) {
  auto labels = std::make_shared<Snapshot::Labels>();
  for (const auto& [label, place] : labels_) {
    if (network.place(place) != nullptr) {
      labels->emplace(label, place);
    } else if (!is_out(place) && !is_left_behind(place)) {
      damage_.push_back("label " + label + ": its place " + to_string(place) + " is not served");
    }
  }
  return labels;
}

}  // namespace weft::storage
