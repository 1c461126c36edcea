#include "core/network/routing/cells.hpp"

#include <algorithm>

#include "core/network/routing/block_search.hpp"
#include "core/network/search.hpp"

namespace weft::routing {
namespace {

struct Joints {
  std::vector<Arc> arcs;
  std::uint8_t entered = 0;
  std::uint8_t left = 0;
};

/// Counts the levels whose borders an arc crosses. Cells are nested: one that crosses a level's crosses all below.
std::uint8_t levels_crossed(const Preparation& preparation, Node a, Node b) {
  std::uint8_t levels = 0;
  while (levels < kLevels && preparation.cell(a, levels) != preparation.cell(b, levels)) ++levels;
  return levels;
}

void join(const Preparation& preparation, Node node, Joints& joints) {
  joints.arcs.clear();
  joints.entered = joints.left = 0;
  const PlaceId& here = preparation.place(node);
  preparation.of.for_each_edge(here, [&](const Edge& edge) {
    if (edge.drivable == Drivable::none || !preparation.methods.contains(edge.method)) return;
    const PlaceId there = other_end(edge, here);
    const Node other = preparation.node(there);
    if (other == kNoNode) return;
    const std::uint8_t crossed = levels_crossed(preparation, node, other);
    if (can_drive(edge, here)) {
      joints.arcs.push_back({other, norm(edge.a_from_b)});
      joints.left = std::max(joints.left, crossed);
    }
    if (can_drive(edge, there)) joints.entered = std::max(joints.entered, crossed);
  });
}

}  // namespace

BaseCell joined(const Preparation& preparation, std::uint32_t cell) {
  BaseCell made;
  made.places = preparation.base[cell]->places;
  made.entered.resize(made.places.size());
  made.left.resize(made.places.size());
  made.first_arc.reserve(made.places.size() + 1);
  Joints joints;
  for (std::uint32_t slot = 0; slot < made.places.size(); ++slot) {
    made.first_arc.push_back(static_cast<std::uint32_t>(made.arcs.size()));
    if (!made.places[slot]) continue;
    join(preparation, node_at(cell, slot), joints);
    made.arcs.insert(made.arcs.end(), joints.arcs.begin(), joints.arcs.end());
    made.entered[slot] = joints.entered;
    made.left[slot] = joints.left;
  }
  made.first_arc.push_back(static_cast<std::uint32_t>(made.arcs.size()));
  made.arcs.shrink_to_fit();
  return made;
}

bool is_joined(const Preparation& preparation, Node node) {
  const BaseCell& base = *preparation.base[cell_of(node)];
  const std::uint32_t slot = slot_of(node);
  if (slot + 1 >= base.first_arc.size()) return false;
  Joints joints;
  join(preparation, node, joints);
  return joints.entered == base.entered[slot] && joints.left == base.left[slot] &&
         std::equal(joints.arcs.begin(), joints.arcs.end(), base.arcs.begin() + base.first_arc[slot],
                    base.arcs.begin() + base.first_arc[slot + 1]);
}

Overlay bordered(const Preparation& preparation, std::size_t level, std::uint32_t cell,
                 std::vector<std::uint32_t> children) {
  Overlay made;
  if (level == 0) {
    const BaseCell& base = *preparation.base[cell];
    for (std::uint32_t slot = 0; slot < base.places.size(); ++slot) {
      if (base.entered[slot] > 0) made.entries.push_back(node_at(cell, slot));
      if (base.left[slot] > 0) made.exits.push_back(node_at(cell, slot));
    }
  }
  for (const std::uint32_t child : children) {
    const Overlay& below = *preparation.overlays[level - 1][child];
    for (const Node entry : below.entries) {
      if (preparation.base[cell_of(entry)]->entered[slot_of(entry)] > level) made.entries.push_back(entry);
    }
    for (const Node exit : below.exits) {
      if (preparation.base[cell_of(exit)]->left[slot_of(exit)] > level) made.exits.push_back(exit);
    }
  }
  std::sort(made.entries.begin(), made.entries.end());
  std::sort(made.exits.begin(), made.exits.end());
  made.children = std::move(children);
  for (const Node exit : made.exits) {
    made.first_crossing.push_back(static_cast<std::uint32_t>(made.crossings.size()));
    const BaseCell& base = *preparation.base[cell_of(exit)];
    for (std::uint32_t at = base.first_arc[slot_of(exit)]; at < base.first_arc[slot_of(exit) + 1]; ++at) {
      if (preparation.cell(base.arcs[at].to, level) != cell) made.crossings.push_back(base.arcs[at]);
    }
  }
  made.first_crossing.push_back(static_cast<std::uint32_t>(made.crossings.size()));
  return made;
}

void measure(const Preparation& preparation, std::size_t level, std::uint32_t cell, Overlay& overlay) {
  overlay.costs.clear();
  overlay.costs.reserve(overlay.entries.size() * overlay.exits.size());
  BlockSearch search(preparation);
  search.confine(level, cell);
  for (const Node entry : overlay.entries) {
    search.start(entry);
    search.run();
    for (const Node exit : overlay.exits) overlay.costs.push_back(search.cost(exit));
  }
}

}  // namespace weft::routing
