#include <algorithm>
#include <bit>

#include "core/network/window.hpp"

namespace weft {
namespace {

bool same(const Place& first, const Place& second) {
  return first == second;
}
bool same(const Edge& first, const Edge& second) {
  return first.entity_version == second.entity_version && first.origin == second.origin &&
         first.method == second.method && first.drivable == second.drivable && first.inliers == second.inliers &&
         std::bit_cast<std::uint32_t>(first.overlap) == std::bit_cast<std::uint32_t>(second.overlap) &&
         identical(first.a_from_b, second.a_from_b);
}
bool same(const PlaceId& first, const PlaceId& second) {
  return first == second;
}

/// Walks two sorted maps side by side.
template <class Map, class Added, class Changed, class Removed>
void compare(const Map& base, const Map& target, Added&& added, Changed&& changed, Removed&& removed) {
  auto old = base.begin();
  auto now = target.begin();
  while (old != base.end() || now != target.end()) {
    if (now == target.end() || (old != base.end() && old->first < now->first)) {
      removed(*old++);
    } else if (old == base.end() || now->first < old->first) {
      added(*now++);
    } else {
      if (!same(old->second, now->second)) changed(*now);
      ++old;
      ++now;
    }
  }
}

/// Checks that edges and labels stay within the window. Indexes the window as well.
Result<void> check_ends(Window& window) {
  if (const std::optional<PlaceId> outside = index_edges(window)) {
    return fail(ErrorCode::corrupt, "patch: an edge ends at " + to_string(*outside) + ", which is not in the window");
  }
  for (const auto& [label, place] : window.labels) {
    if (window.place(place) == nullptr) {
      return fail(ErrorCode::corrupt,
                  "patch: label " + label + " is at " + to_string(place) + ", which is not in the window");
    }
  }
  return {};
}

}  // namespace

Patch difference(const Window& base, const Window& target) {
  return difference(base, target, digest(target));
}

Patch difference(const Window& base, const Window& target, const Digest& target_digest) {
  Patch patch;
  patch.base = base.revision;
  patch.target = target.revision;
  compare(
      base.places, target.places, [&](const auto& entry) { patch.added.push_back(entry.second); },
      [&](const auto& entry) { patch.changed.push_back(entry.second); },
      [&](const auto& entry) { patch.removed.push_back(entry.first); });
  const auto new_edge = [&](const auto& entry) { patch.edges.push_back(entry.second); };
  compare(base.edges, target.edges, new_edge, new_edge,
          [&](const auto& entry) { patch.edges_removed.push_back(entry.first); });
  const auto new_label = [&](const auto& entry) { patch.labels.insert(entry); };
  compare(base.labels, target.labels, new_label, new_label,
          [&](const auto& entry) { patch.labels_removed.push_back(entry.first); });
  patch.digest = target_digest;
  return patch;
}

Result<Window> apply(const Window& base, const Patch& patch) {
  if (patch.base.value != 0 && patch.base != base.revision) {
    return fail(ErrorCode::stale, "patch: made from revision " + std::to_string(patch.base.value) +
                                      ", the window has revision " + std::to_string(base.revision.value));
  }
  Window window = patch.base.value == 0 ? Window{} : base;
  window.revision = patch.target;
  window.edges.erase_all(patch.edges_removed);
  window.places.erase_all(patch.removed);
  for (const std::string& label : patch.labels_removed) window.labels.erase(label);
  for (const Place& place : patch.added) window.places.insert_or_assign(place.id, place);
  for (const Place& place : patch.changed) window.places.insert_or_assign(place.id, place);
  for (const Edge& edge : patch.edges) window.edges.insert_or_assign(edge.id, edge);
  for (const auto& [label, place] : patch.labels) window.labels.insert_or_assign(label, place);
  if (const auto checked = check_ends(window); !checked) return fail(checked.error());
  if (digest(window) != patch.digest) {
    return fail(ErrorCode::corrupt, "patch: the window at revision " + std::to_string(patch.target.value) +
                                        " has another digest than the server's; ask for a fresh window");
  }
  return window;
}

std::vector<Patch> split(const Patch& patch, std::size_t max_entities) {
  Patch empty;
  empty.base = patch.base;
  empty.target = patch.target;
  empty.digest = patch.digest;
  std::vector<Patch> parts{empty};
  std::size_t room = std::max<std::size_t>(1, max_entities);
  const auto deal = [&](const auto& entities, auto member) {
    for (const auto& entity : entities) {
      if (room == 0) {
        parts.push_back(empty);
        room = std::max<std::size_t>(1, max_entities);
      }
      auto& into = parts.back().*member;
      into.insert(into.end(), entity);
      --room;
    }
  };
  deal(patch.added, &Patch::added);
  deal(patch.changed, &Patch::changed);
  deal(patch.removed, &Patch::removed);
  deal(patch.edges, &Patch::edges);
  deal(patch.edges_removed, &Patch::edges_removed);
  deal(patch.labels, &Patch::labels);
  deal(patch.labels_removed, &Patch::labels_removed);
  return parts;
}

Result<Patch> join(const std::vector<Patch>& parts) {
  if (parts.empty()) return fail(ErrorCode::corrupt, "patch: has no parts");
  Patch whole = parts.front();
  const auto append = [](auto& into, const auto& from) { into.insert(into.end(), from.begin(), from.end()); };
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const Patch& part = parts[i];
    if (part.base != whole.base || part.target != whole.target || part.digest != whole.digest) {
      return fail(ErrorCode::corrupt, "patch: part " + std::to_string(i) + " belongs to another patch than part 0");
    }
    append(whole.added, part.added);
    append(whole.changed, part.changed);
    append(whole.removed, part.removed);
    append(whole.edges, part.edges);
    append(whole.edges_removed, part.edges_removed);
    whole.labels.insert(part.labels.begin(), part.labels.end());
    append(whole.labels_removed, part.labels_removed);
  }
  return whole;
}

}  // namespace weft
