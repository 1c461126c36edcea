#include <algorithm>
#include <set>

#include "core/network/change.hpp"

namespace weft {
namespace {

/// Changes experiences of a snapshot: copies one when it is touched, shares the others.
class Draft {
 public:
  explicit Draft(const Snapshot& snapshot) : experiences_(snapshot.experiences()) {}

  Experience& touch(ExperienceId id) {
    auto& copy = touched_[id];
    if (!copy) {
      const auto found = experiences_.find(id);
      copy =
          found == experiences_.end() ? std::make_shared<Experience>() : std::make_shared<Experience>(*found->second);
      copy->id = id;
    }
    return *copy;
  }

  /// Adds a stitch, unless one of its ends was taken out of the map: it comes with that end when that comes back.
  void stitch(const Edge& edge) {
    if (!has(edge.id.a) || !has(edge.id.b)) return;
    const auto shared = std::make_shared<const Edge>(edge);
    touch_stitches(edge.id.a.experience).push_back(shared);
    if (edge.id.b.experience != edge.id.a.experience) touch_stitches(edge.id.b.experience).push_back(shared);
  }

  void learn(const std::vector<Place>& learned) {
    std::map<ExperienceId, std::map<std::size_t, Place>> by_experience;
    for (const Place& place : learned) {
      const Experience& experience = touch(place.id.experience);
      const Place* const known = experience.place(place.id.index);
      if (known == nullptr) continue;
      const auto at = std::ranges::lower_bound(experience.places, place.id.index, {},
                                               [](const Place& one) { return one.id.index; });
      by_experience[place.id.experience].emplace(at - experience.places.begin(), place);
    }
    for (const auto& [id, places] : by_experience) touch(id).places.replace(places);
  }

  Snapshot::Experiences take() {
    for (const ExperienceId id : stitched_) index_stitches(*touched_.at(id));
    for (auto& [id, experience] : touched_) experiences_[id] = std::move(experience);
    return std::move(experiences_);
  }

 private:
  bool has(const PlaceId& id) const {
    if (const auto changed = touched_.find(id.experience); changed != touched_.end()) {
      return changed->second->place(id.index) != nullptr;
    }
    const auto found = experiences_.find(id.experience);
    return found != experiences_.end() && found->second->place(id.index) != nullptr;
  }
  SharedItems<Edge>& touch_stitches(ExperienceId id) {
    stitched_.insert(id);
    return touch(id).stitches;
  }

  Snapshot::Experiences experiences_;
  std::map<ExperienceId, std::shared_ptr<Experience>> touched_;
  std::set<ExperienceId> stitched_;
};

Revision next(Revision revision) {
  return {revision.value + 1};
}

std::shared_ptr<const Snapshot::Labels> share(Snapshot::Labels labels) {
  return std::make_shared<const Snapshot::Labels>(std::move(labels));
}

}  // namespace

void set_places(Batch& batch, std::vector<Place> all) {
  const auto is_learned = [&](const Place& place) { return place.id.experience != batch.experience; };
  const auto first = std::ranges::find_if(all, is_learned);
  batch.learned.assign(first, all.end());
  all.erase(first, all.end());
  batch.places = std::move(all);
}

Batch in_time(const Snapshot& snapshot, Batch batch) {
  std::erase_if(batch.learned, [&](const Place& place) {
    const Place* const known = snapshot.place(place.id);
    return known == nullptr || known->entity_version + 1 != place.entity_version;
  });
  return batch;
}

Snapshot with(const Snapshot& snapshot, const Batch& batch) {
  Draft draft(snapshot);
  Experience& experience = draft.touch(batch.experience);
  if (experience.extent == 0) {
    experience.robot = batch.robot;
    experience.name = batch.name;
    experience.method = batch.method;
  }
  experience.places.append(batch.places);
  experience.extent += static_cast<std::uint32_t>(batch.places.size());
  std::vector<Edge> hops;
  for (const Edge& edge : batch.edges) {
    if (edge.origin == Origin::stitch) {
      draft.stitch(edge);
    } else {
      hops.push_back(edge);
    }
  }
  // All of them come after the chain so far: the batch continues the experience.
  std::sort(hops.begin(), hops.end(), [](const Edge& first, const Edge& second) { return first.id < second.id; });
  experience.chain.append(std::move(hops));
  draft.learn(batch.learned);
  if (batch.seal) {
    experience.sealed = true;
    experience.seal_reason = batch.seal_reason;
  }
  return {next(snapshot.revision()), draft.take(),
          snapshot.shared_labels(),  snapshot.shared_aparts(),
          snapshot.shared_rules(),   snapshot.shared_registrations()};
}

Snapshot with_label(const Snapshot& snapshot, const std::string& label, const PlaceId& place) {
  Snapshot::Labels labels = snapshot.labels();
  labels[label] = place;
  return {next(snapshot.revision()), snapshot.experiences(),  share(std::move(labels)),
          snapshot.shared_aparts(),  snapshot.shared_rules(), snapshot.shared_registrations()};
}

Snapshot with_seal(const Snapshot& snapshot, ExperienceId experience, const std::string& reason) {
  Draft draft(snapshot);
  if (snapshot.experience(experience) != nullptr) {
    Experience& sealed = draft.touch(experience);
    sealed.sealed = true;
    sealed.seal_reason = reason;
  }
  return {next(snapshot.revision()), draft.take(),
          snapshot.shared_labels(),  snapshot.shared_aparts(),
          snapshot.shared_rules(),   snapshot.shared_registrations()};
}

}  // namespace weft
