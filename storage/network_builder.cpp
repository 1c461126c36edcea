#include "storage/network_builder.hpp"

#include <algorithm>

namespace weft::storage {
namespace {

std::uint32_t index_of(const Place& place) {
  return place.id.index;
}
std::uint32_t index_of(const Edge& edge) {
  return edge.id.a.index;
}

/// Sorts by index; of equal ones the last added stays.
template <class Row>
void sort_latest(std::vector<Row>& rows) {
  const auto is_before = [](const Row& left, const Row& right) { return index_of(left) < index_of(right); };
  if (!std::is_sorted(rows.begin(), rows.end(), is_before)) std::stable_sort(rows.begin(), rows.end(), is_before);
  const auto is_same = [](const Row& left, const Row& right) { return index_of(left) == index_of(right); };
  const auto kept = std::unique(rows.rbegin(), rows.rend(), is_same);
  rows.erase(rows.begin(), kept.base());
}

/// How many rows stand at their own index from 0 on.
template <class Row>
std::size_t contiguous(const std::vector<Row>& rows) {
  std::size_t count = 0;
  while (count < rows.size() && index_of(rows[count]) == count) ++count;
  return count;
}

bool is_served(const std::map<ExperienceId, Experience>& experiences, const PlaceId& id) {
  const auto found = experiences.find(id.experience);
  return found != experiences.end() && id.index < found->second.places.size();
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

void NetworkBuilder::add(Edge edge) {
  if (edge.origin == Origin::stitch) {
    stitches_.push_back(std::move(edge));
  } else {
    rows_[edge.id.a.experience].chain.push_back(std::move(edge));
  }
}

void NetworkBuilder::add_label(const std::string& label, const PlaceId& place) {
  labels_[label] = place;
}

void NetworkBuilder::add_damage(std::string what) {
  damage_.push_back(std::move(what));
}

Experience NetworkBuilder::assemble(Rows& rows) {
  sort_latest(rows.places);
  sort_latest(rows.chain);
  const std::size_t joined = contiguous(rows.chain) + 1;
  const std::size_t served = std::min(contiguous(rows.places), joined);
  const std::uint64_t expected = std::max<std::uint64_t>(rows.head.places, rows.places.size());
  if (served < expected) {
    damage_.push_back("experience " + to_string(rows.head.id) + ": the row of place " + std::to_string(served) +
                      " or of the edge before it is damaged or missing; places " + std::to_string(served) + " to " +
                      std::to_string(expected - 1) + " are not served");
  }
  rows.places.resize(served);
  rows.chain.resize(served == 0 ? 0 : served - 1);
  Experience experience;
  experience.id = rows.head.id;
  experience.robot = rows.head.robot;
  experience.name = std::move(rows.head.name);
  experience.method = std::move(rows.head.method);
  experience.sealed = rows.head.sealed;
  experience.seal_reason = std::move(rows.head.seal_reason);
  experience.places = std::move(rows.places);
  experience.chain = std::move(rows.chain);
  return experience;
}

void NetworkBuilder::join_stitches(std::map<ExperienceId, Experience>& experiences) {
  std::stable_sort(stitches_.begin(), stitches_.end(),
                   [](const Edge& left, const Edge& right) { return left.id < right.id; });
  for (std::size_t at = 0; at < stitches_.size(); ++at) {
    const Edge& stitch = stitches_[at];
    if (at + 1 < stitches_.size() && stitches_[at + 1].id == stitch.id) continue;  // replaced
    if (!is_served(experiences, stitch.id.a) || !is_served(experiences, stitch.id.b)) {
      damage_.push_back("stitch " + name_of(stitch.id) + ": one of its places is not served");
      continue;
    }
    experiences.at(stitch.id.a.experience).stitches.push_back(stitch);
    if (stitch.id.b.experience != stitch.id.a.experience) {
      experiences.at(stitch.id.b.experience).stitches.push_back(stitch);
    }
  }
  for (auto& [id, experience] : experiences) index_stitches(experience);
}

Snapshot NetworkBuilder::build(Revision revision) {
  std::map<ExperienceId, Experience> experiences;
  for (auto& [id, rows] : rows_) {
    if (!rows.head.id) {
      damage_.push_back("experience " + to_string(id) + ": its row is missing; it is not served");
      continue;
    }
    experiences.emplace_hint(experiences.end(), id, assemble(rows));
  }
  join_stitches(experiences);

  auto labels = std::make_shared<Snapshot::Labels>();
  for (const auto& [label, place] : labels_) {
    if (is_served(experiences, place)) {
      labels->emplace(label, place);
    } else {
      damage_.push_back("label " + label + ": its place " + to_string(place) + " is not served");
    }
  }
  Snapshot::Experiences shared;
  for (auto& [id, experience] : experiences) {
    shared.emplace_hint(shared.end(), id, std::make_shared<const Experience>(std::move(experience)));
  }
  return {revision, std::move(shared), std::move(labels)};
}

}  // namespace weft::storage
