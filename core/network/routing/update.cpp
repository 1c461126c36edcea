#include "core/network/routing/cells.hpp"
#include "core/network/routing/draft.hpp"
#include "core/network/routing/routing.hpp"

namespace weft::routing {
namespace {

/// Experiences that one of the snapshots has and the other has not, or not as it is.
std::vector<ExperienceId> differing(const Snapshot& a, const Snapshot& b) {
  std::vector<ExperienceId> ids;
  auto in_a = a.experiences().begin();
  auto in_b = b.experiences().begin();
  while (in_a != a.experiences().end() || in_b != b.experiences().end()) {
    const bool take_a =
        in_b == b.experiences().end() || (in_a != a.experiences().end() && in_a->first <= in_b->first);
    const bool take_b =
        in_a == a.experiences().end() || (in_b != b.experiences().end() && in_b->first <= in_a->first);
    if (!take_a || !take_b || in_a->second != in_b->second) ids.push_back(take_a ? in_a->first : in_b->first);
    if (take_a) ++in_a;
    if (take_b) ++in_b;
  }
  return ids;
}

}  // namespace

Preparation update(const Preparation& preparation, const Snapshot& snapshot) {
  Preparation next = preparation;
  next.of = snapshot;
  Draft draft(std::move(next));
  const Snapshot& before = preparation.of;
  std::vector<PlaceId> touched;
  const auto touch_around = [&](const Snapshot& network, const PlaceId& place) {
    network.for_each_edge(place, [&](const Edge& edge) { touched.push_back(other_end(edge, place)); });
  };
  const std::vector<ExperienceId> ids = differing(before, snapshot);
  for (const ExperienceId id : ids) {
    const Experience* const old = before.experience(id);
    if (old == nullptr) continue;
    for (const Place& place : old->places) {
      if (snapshot.place(place.id) != nullptr) continue;
      draft.remove(place.id);
      touch_around(before, place.id);
    }
  }
  for (const ExperienceId id : ids) {
    const Experience* const now = snapshot.experience(id);
    if (now == nullptr) continue;
    for (const Place& place : now->places) {
      touched.push_back(place.id);
      if (draft.preparation().node(place.id) != kNoNode) continue;
      draft.add(place.id);
      touch_around(snapshot, place.id);
    }
  }
  for (const PlaceId& place : touched) {
    const Node node = draft.preparation().node(place);
    if (node != kNoNode && !is_joined(draft.preparation(), node)) draft.mark(cell_of(node));
  }
  while (draft.step()) {
  }
  return draft.take();
}

}  // namespace weft::routing
