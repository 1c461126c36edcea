#include "clients/cli/difference.hpp"

#include <algorithm>
#include <iterator>

namespace weft::cli {
namespace {

bool is_stitch(const Edge& edge) {
  return edge.origin == Origin::stitch;
}

/// Merges two maps; where both have a key, the value of `to` counts. Linear: nothing is put into the middle.
template <class Map>
Map merged(const Map& from, const Map& to) {
  Map both;
  both.reserve(from.size() + to.size());
  auto old = from.begin();
  for (const auto& [id, value] : to) {
    for (; old != from.end() && old->first < id; ++old) both.emplace(old->first, old->second);
    both.emplace(id, value);
    if (old != from.end() && old->first == id) ++old;
  }
  for (; old != from.end(); ++old) both.emplace(old->first, old->second);
  return both;
}

/// Compares what has a name: which came, changed and went.
template <class T>
void compare_named(const std::vector<T>& from, const std::vector<T>& to, std::string T::*name,
                   std::vector<std::string>& added, std::vector<std::string>& changed,
                   std::vector<std::string>& removed) {
  for (const T& one : to) {
    const auto before = std::ranges::find(from, one.*name, name);
    if (before == from.end()) {
      added.push_back(one.*name);
    } else if (*before != one) {
      changed.push_back(one.*name);
    }
  }
  for (const T& one : from) {
    if (std::ranges::find(to, one.*name, name) == to.end()) removed.push_back(one.*name);
  }
}

}  // namespace

bool NetworkDifference::empty() const {
  return places_added.empty() && places_removed.empty() && places_anew.empty() && stitches_added.empty() &&
         stitches_removed.empty() && labels_added.empty() && labels_moved.empty() && labels_removed.empty() &&
         aparts_added.empty() && aparts_removed.empty() && rules_added.empty() && rules_changed.empty() &&
         rules_removed.empty() && plans_added.empty() && plans_changed.empty() && plans_removed.empty();
}

NetworkDifference compare(const Window& from, const Window& to) {
  NetworkDifference found;
  found.from = from.revision;
  found.to = to.revision;
  for (const auto& [id, place] : to.places) {
    const Place* const before = from.place(id);
    if (before == nullptr) {
      found.places_added.push_back(id);
    } else if (before->content != place.content) {
      found.places_anew.push_back(id);
    }
  }
  for (const auto& [id, place] : from.places) {
    if (to.place(id) == nullptr) found.places_removed.push_back(id);
  }
  for (const auto& [id, edge] : to.edges) {
    if (is_stitch(edge) && from.edges.value(id) == nullptr) found.stitches_added.push_back(id);
  }
  for (const auto& [id, edge] : from.edges) {
    if (is_stitch(edge) && to.edges.value(id) == nullptr) found.stitches_removed.push_back(id);
  }
  for (const auto& [label, place] : to.labels) {
    const auto before = from.labels.find(label);
    if (before == from.labels.end()) {
      found.labels_added.push_back(label);
    } else if (before->second != place) {
      found.labels_moved.push_back(label);
    }
  }
  for (const auto& [label, place] : from.labels) {
    if (!to.labels.contains(label)) found.labels_removed.push_back(label);
  }
  return found;
}

void compare_aparts(const std::vector<Apart>& from, const std::vector<Apart>& to, NetworkDifference& found) {
  std::ranges::set_difference(to, from, std::back_inserter(found.aparts_added));
  std::ranges::set_difference(from, to, std::back_inserter(found.aparts_removed));
}

void compare_rules(const std::vector<Rule>& from, const std::vector<Rule>& to, NetworkDifference& found) {
  compare_named(from, to, &Rule::name, found.rules_added, found.rules_changed, found.rules_removed);
}

void compare_registrations(const std::vector<Registration>& from, const std::vector<Registration>& to,
                           NetworkDifference& found) {
  compare_named(from, to, &Registration::plan, found.plans_added, found.plans_changed, found.plans_removed);
}

Window united(const Window& from, const Window& to) {
  Window both;
  both.revision = to.revision;
  both.places = merged(from.places, to.places);
  both.edges = merged(from.edges, to.edges);
  both.labels = to.labels;
  both.labels.insert(from.labels.begin(), from.labels.end());
  index_edges(both);
  return both;
}

}  // namespace weft::cli
