#include "core/network/routing/draft.hpp"

#include <utility>

#include "core/network/routing/cells.hpp"
#include "core/network/search.hpp"

namespace weft::routing {

std::vector<Node>& Draft::nodes_of(ExperienceId experience) {
  const auto* const known = made_.nodes.value(experience);
  auto copy = known == nullptr ? std::make_shared<std::vector<Node>>() : std::make_shared<std::vector<Node>>(**known);
  std::vector<Node>& nodes = *copy;
  made_.nodes.insert_or_assign(experience, std::move(copy));
  return nodes;
}

void Draft::add(const PlaceId& place) {
  const std::uint32_t cell = room_near(place);
  auto base = std::make_shared<BaseCell>(*made_.base[cell]);
  const auto slot = static_cast<std::uint32_t>(base->places.size());
  base->places.push_back(place);
  made_.base[cell] = std::move(base);
  std::vector<Node>& nodes = nodes_of(place.experience);
  if (nodes.size() <= place.index) nodes.resize(place.index + 1, kNoNode);
  nodes[place.index] = node_at(cell, slot);
  mark(cell);
}

void Draft::remove(const PlaceId& place) {
  const Node node = made_.node(place);
  auto base = std::make_shared<BaseCell>(*made_.base[cell_of(node)]);
  base->places[slot_of(node)] = PlaceId{};
  made_.base[cell_of(node)] = std::move(base);
  nodes_of(place.experience)[place.index] = kNoNode;
  mark(cell_of(node));
}

void Draft::look_at(std::uint32_t cell, bool costs_too) {
  stale_[0].insert(cell);
  if (costs_too) changed_inside_[0].insert(cell);
}

/// Finds a base cell for a place, beside its neighbour over the last edge. Stitches, which come last, tell better
/// than the chain what lies beside a place: cells that follow a run would be long and thin.
std::uint32_t Draft::room_near(const PlaceId& place) {
  std::uint32_t near = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t with_room = near;
  const auto look = [&](const Edge& edge) {
    const Node other = made_.node(other_end(edge, place));
    if (other == kNoNode) return;
    near = cell_of(other);
    if (made_.base[near]->places.size() < kBaseRoom) with_room = near;
  };
  made_.of.for_each_edge(place, look);  // the last one counts: stitches come after odometry
  constexpr auto kNowhere = std::numeric_limits<std::uint32_t>::max();
  if (with_room != kNowhere) return with_room;
  if (near != kNowhere) return new_cell(near);
  if (newest_ >= made_.base.size() || made_.base[newest_]->places.size() >= kBaseRoom) newest_ = new_cell(newest_);
  return newest_;
}

/// Adds a base cell beside another one, within the smallest cell over that one that has room for one more.
std::uint32_t Draft::new_cell(std::uint32_t near) {
  const auto cell = static_cast<std::uint32_t>(made_.base.size());
  std::array<std::uint32_t, kLevels> cells{};
  for (std::size_t level = 0; level < kLevels; ++level) {
    cells[level] = static_cast<std::uint32_t>(made_.overlays[level].size());
  }
  std::size_t level = 1;  // the first one that is there already
  while (level < kLevels && (near >= made_.base.size() ||
                             made_.overlays[level][made_.cells[near][level]]->children.size() >= kMostChildren)) {
    ++level;
  }
  for (std::size_t above = level; above < kLevels; ++above) cells[above] = made_.cells[near][above];
  auto base = std::make_shared<BaseCell>();
  base->first_arc.push_back(0);
  made_.base.push_back(std::move(base));
  made_.cells.push_back(cells);
  for (std::size_t fresh = 0; fresh < level; ++fresh) {
    auto overlay = std::make_shared<Overlay>();
    if (fresh > 0) overlay->children.push_back(cells[fresh - 1]);
    overlay->first_crossing.push_back(0);
    made_.overlays[fresh].push_back(std::move(overlay));
  }
  if (level < kLevels) {
    auto parent = std::make_shared<Overlay>(*made_.overlays[level][cells[level]]);
    parent->children.push_back(cells[level - 1]);
    made_.overlays[level][cells[level]] = std::move(parent);
  }
  return cell;
}

std::size_t Draft::step() {
  if (!marked_.empty()) {
    const std::uint32_t cell = *marked_.begin();
    marked_.erase(marked_.begin());
    return remake_base(cell);
  }
  for (std::size_t level = 0; level < kLevels; ++level) {
    if (stale_[level].empty()) continue;
    const std::uint32_t cell = *stale_[level].begin();
    stale_[level].erase(stale_[level].begin());
    return remake_overlay(level, cell);
  }
  return 0;
}

std::size_t Draft::left_to_do() const {
  std::size_t cells = marked_.size();
  for (const auto& level : stale_) cells += level.size();
  return cells;
}

std::size_t Draft::remake_base(std::uint32_t cell) {
  BaseCell made = joined(made_, cell);
  const std::size_t work = 1 + made.places.size();
  if (made == *made_.base[cell]) return work;
  made_.base[cell] = std::make_shared<const BaseCell>(std::move(made));
  look_at(cell, true);
  return work;
}

namespace {

/// Estimates the work of `measure`: each entry's search looks at every arc of a base cell, or at every cost of the
/// cells within.
std::size_t work_of_measuring(const Preparation& preparation, std::size_t level, std::uint32_t cell,
                              const Overlay& overlay) {
  constexpr std::size_t kArcs = 16;    // gone along in a microsecond
  constexpr std::size_t kCosts = 128;  // looked at in a microsecond
  if (level == 0) return overlay.entries.size() * preparation.base[cell]->arcs.size() / kArcs;
  std::size_t costs = 0;
  for (const std::uint32_t child : overlay.children) costs += preparation.overlays[level - 1][child]->costs.size();
  return overlay.entries.size() * costs / kCosts;
}

}  // namespace

/// Makes an overlay anew and has the one above looked at; returns the work. Costs change only when something within
/// the cell does; borders can also move because a place that could be left to the next cell can now be left to one
/// farther off. An overlay of stored bytes has no crossings yet: then only what it was made of tells that nothing
/// changed.
std::size_t Draft::remake_overlay(std::size_t level, std::uint32_t cell) {
  const Overlay& old = *made_.overlays[level][cell];
  Overlay made = bordered(made_, level, cell, old.children);
  const bool has_crossings = !old.first_crossing.empty();
  const bool same_crossings = made.first_crossing == old.first_crossing && made.crossings == old.crossings;
  const bool same_borders =
      made.entries == old.entries && made.exits == old.exits && (same_crossings || !has_crossings);
  const bool same_inside = changed_inside_[level].erase(cell) == 0;
  bool is_same = same_borders && same_inside;
  std::size_t work = 1 + made.entries.size() + made.exits.size();
  if (is_same) {
    made.costs = old.costs;
  } else {
    measure(made_, level, cell, made);
    work += work_of_measuring(made_, level, cell, made);
    is_same = has_crossings && same_borders && made.costs == old.costs;
  }
  if (level + 1 < kLevels) {
    std::uint32_t base = cell;  // any one within knows the way up
    for (std::size_t at = level; at > 0; --at) base = made_.overlays[at][base]->children.front();
    const std::uint32_t parent = made_.cells[base][level + 1];
    stale_[level + 1].insert(parent);
    if (!is_same) changed_inside_[level + 1].insert(parent);
  }
  if (!is_same || !has_crossings) made_.overlays[level][cell] = std::make_shared<const Overlay>(std::move(made));
  return work;
}

}  // namespace weft::routing
