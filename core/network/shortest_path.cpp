#include <algorithm>
#include <limits>
#include <queue>

#include "core/network/no_path.hpp"
#include "core/network/search.hpp"

namespace weft {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Gives the places of a snapshot numbers 0..n-1, in the order of their ids.
class Numbering {
 public:
  explicit Numbering(const Snapshot& snapshot) {
    for (const auto& [id, experience] : snapshot.experiences()) {
      const auto count = experience->extent;
      blocks_.push_back({id, size_, count});
      size_ += count;
    }
  }

  std::uint32_t size() const { return size_; }
  /// Returns the place's number; kNone for a place that its experience never had.
  std::uint32_t number(const PlaceId& id) const {
    const auto block = std::lower_bound(blocks_.begin(), blocks_.end(), id.experience,
                                        [](const Block& b, ExperienceId wanted) { return b.id < wanted; });
    if (block == blocks_.end() || block->id != id.experience || id.index >= block->count) return kNone;
    return block->first + id.index;
  }
  PlaceId id(std::uint32_t number) const {
    const auto after = std::upper_bound(blocks_.begin(), blocks_.end(), number,
                                        [](std::uint32_t wanted, const Block& b) { return wanted < b.first; });
    // Empty experiences share their first number with the next one, which stands after them.
    const Block& block = *(after - 1);
    return {block.id, number - block.first};
  }

 private:
  struct Block {
    ExperienceId id;
    std::uint32_t first = 0;
    std::uint32_t count = 0;
  };
  std::vector<Block> blocks_;
  std::uint32_t size_ = 0;
};

struct Entry {
  double cost = 0.0;
  std::uint32_t number = 0;
  // Reversed: the standard heap keeps its largest on top.
  bool operator<(const Entry& other) const { return cost != other.cost ? cost > other.cost : number > other.number; }
};

struct Label {
  double cost = std::numeric_limits<double>::infinity();
  std::uint32_t parent = kNone;
  bool settled = false;
  const Edge* edge = nullptr;
};

/// Runs Dijkstra's algorithm with a binary heap and lazy deletion; stops when `to` is settled.
std::vector<Label> settle(const Snapshot& snapshot, const Numbering& numbering, std::uint32_t from, std::uint32_t to,
                          const std::set<std::string>& methods) {
  std::vector<Label> labels(numbering.size());
  std::priority_queue<Entry> heap;
  labels[from].cost = 0.0;
  heap.push({0.0, from});
  while (!heap.empty()) {
    const Entry top = heap.top();
    heap.pop();
    if (labels[top.number].settled) continue;
    labels[top.number].settled = true;
    if (top.number == to) break;
    const PlaceId here = numbering.id(top.number);
    snapshot.for_each_edge(here, [&](const Edge& edge) {
      if (!can_drive(edge, here) || !methods.contains(edge.method)) return;
      const std::uint32_t there = numbering.number(other_end(edge, here));
      if (there == kNone) return;
      Label& label = labels[there];
      const double cost = top.cost + norm(edge.a_from_b);
      if (label.settled || cost > label.cost || (cost == label.cost && top.number >= label.parent)) return;
      label = {cost, top.number, false, &edge};
      heap.push({cost, there});
    });
  }
  return labels;
}

Error no_path(const Numbering& numbering, const std::vector<Label>& labels, const PlaceId& from, const PlaceId& to,
              const std::set<std::string>& methods) {
  std::size_t reached = 0;
  std::uint32_t farthest = numbering.number(from);
  for (std::uint32_t i = 0; i < labels.size(); ++i) {
    if (!labels[i].settled) continue;
    ++reached;
    if (labels[i].cost > labels[farthest].cost) farthest = i;
  }
  return {ErrorCode::not_found, no_path_text(from, to, methods) + "; " + std::to_string(reached) +
                                    " places can be reached, the farthest is " + to_string(numbering.id(farthest)) +
                                    "; teach a connection"};
}

}  // namespace

Result<Path> shortest_path(const Snapshot& snapshot, const PlaceId& from, const PlaceId& to,
                           const std::set<std::string>& methods) {
  for (const PlaceId& end : {from, to}) {
    if (snapshot.place(end) == nullptr) {
      return fail(ErrorCode::not_found, "path: place " + to_string(end) + " is not in the network");
    }
  }
  const Numbering numbering(snapshot);
  const std::uint32_t target = numbering.number(to);
  const std::vector<Label> labels = settle(snapshot, numbering, numbering.number(from), target, methods);
  if (!labels[target].settled) return fail(no_path(numbering, labels, from, to, methods));

  Path path;
  path.places.push_back(to);
  for (std::uint32_t at = target; labels[at].parent != kNone; at = labels[at].parent) {
    const PlaceId before = numbering.id(labels[at].parent);
    path.relations.push_back(relation_from(*labels[at].edge, before));
    path.length_m += distance_m(path.relations.back());
    path.places.push_back(before);
  }
  std::reverse(path.places.begin(), path.places.end());
  std::reverse(path.relations.begin(), path.relations.end());
  return path;
}

}  // namespace weft
