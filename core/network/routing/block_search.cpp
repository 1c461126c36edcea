#include "core/network/routing/block_search.hpp"

#include <algorithm>

namespace weft::routing {
namespace {
constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr std::size_t kChildren = 4;
constexpr std::size_t kLabels = 8192;  ///< of a search in a network of a million places
}  // namespace

BlockSearch::BlockSearch(const Preparation& preparation) : preparation_(preparation) {
  for (std::size_t level = 0; level < kLevels; ++level) {
    blocks_at_[level].assign(preparation.overlays[level].size(), kNone);
  }
  blocks_at_[kOpen].assign(preparation.base.size(), kNone);
  entries_.reserve(kLabels);
  heaped_.reserve(kLabels);
  exit_costs_.reserve(kLabels);
  exit_entries_.reserve(kLabels);
  heap_.reserve(kLabels);
}

void BlockSearch::confine(std::size_t level, std::uint32_t cell) {
  level_ = level;
  cell_ = cell;
  opens_ = false;
}

void BlockSearch::search_all(Node from, Node to) {
  level_ = kLevels;
  opens_ = true;
  opened_ = {preparation_.cells[cell_of(from)], preparation_.cells[cell_of(to)]};
}

void BlockSearch::start(Node from, double farthest) {
  farthest_ = farthest;
  for (const Block& block : blocks_) blocks_at_[block.level][block.cell] = kNone;
  blocks_.clear();
  entries_.clear();
  heaped_.clear();
  exit_costs_.clear();
  exit_entries_.clear();
  heap_.clear();
  relax(from, 0.0, kNone, 0);
}

/// Finds the largest cell within the scope that holds the node and is not opened; else its base cell, as open.
BlockSearch::Where BlockSearch::where(Node node) const {
  const auto& cells = preparation_.cells[cell_of(node)];
  for (std::size_t level = level_; level-- > 0;) {
    if (!is_opened(level, cells[level])) return {level, cells[level]};
  }
  return {kOpen, cell_of(node)};
}

std::uint32_t BlockSearch::block_of(Where at) {
  const std::uint32_t known = blocks_at_[at.level][at.cell];
  return known != kNone ? known : new_block(at);
}

std::uint32_t BlockSearch::new_block(Where at) {
  const auto number = static_cast<std::uint32_t>(blocks_.size());
  blocks_at_[at.level][at.cell] = number;
  Block block{
      at.level, at.cell, static_cast<std::uint32_t>(entries_.size()), static_cast<std::uint32_t>(exit_costs_.size()),
      nullptr,  nullptr};
  if (at.level == kOpen) {
    block.base = preparation_.base[at.cell].get();
    entries_.resize(entries_.size() + block.base->places.size(), {kFar, kNone, 0});
  } else {
    block.overlay = preparation_.overlays[at.level][at.cell].get();
    entries_.resize(entries_.size() + block.overlay->entries.size(), {kFar, kNone, 0});
    exit_costs_.resize(exit_costs_.size() + block.overlay->exits.size(), kFar);
    exit_entries_.resize(exit_costs_.size(), 0);
  }
  heaped_.resize(entries_.size(), kNone);
  blocks_.push_back(block);
  return number;
}

std::uint32_t BlockSearch::known_block(Node node) const {
  const Where at = where(node);
  return blocks_at_[at.level][at.cell];
}

std::uint32_t BlockSearch::slot_in(const Block& block, Node node) const {
  if (block.overlay == nullptr) return slot_of(node);
  const auto& entries = block.overlay->entries;
  const auto found = std::lower_bound(entries.begin(), entries.end(), node);
  return found == entries.end() || *found != node ? kNone : static_cast<std::uint32_t>(found - entries.begin());
}

void BlockSearch::relax(Node node, double cost, std::uint32_t parent_block, std::uint32_t parent_slot) {
  if (cost > farthest_) return;
  const std::uint32_t number = block_of(where(node));
  const std::uint32_t slot = slot_in(blocks_[number], node);
  if (slot != kNone) improve(number, slot, cost, parent_block, parent_slot);
}

void BlockSearch::improve(std::uint32_t block, std::uint32_t slot, double cost, std::uint32_t parent_block,
                          std::uint32_t parent_slot) {
  const std::uint32_t at = blocks_[block].first_entry + slot;
  Label& label = entries_[at];
  if (cost >= label.cost || cost > farthest_) return;
  label = {cost, parent_block, parent_slot};
  if (heaped_[at] == kNone) {
    heap_.emplace_back();
    rise({cost, block, at}, heap_.size() - 1);
  } else {
    rise({cost, block, at}, heaped_[at]);
  }
}

void BlockSearch::settle(const Entry& entry) {
  const Block block = blocks_[entry.block];  // a copy: more blocks may come
  const std::uint32_t slot = entry.label - block.first_entry;
  if (block.overlay == nullptr) return settle_open(block, entry.block, slot, entry.cost);
  const std::size_t exits = block.overlay->exits.size();
  const double* const row = block.overlay->costs.data() + slot * exits;
  for (std::uint32_t exit = 0; exit < exits; ++exit) {
    const double* const so_far = exit_costs_.data() + block.first_exit;  // moves when a block comes
    while (exit < exits && entry.cost + row[exit] >= so_far[exit]) ++exit;
    if (exit < exits) leave_by(block, entry.block, slot, exit, entry.cost + row[exit]);
  }
}

void BlockSearch::settle_open(const Block& block, std::uint32_t number, std::uint32_t slot, double cost) {
  const BaseCell& base = *block.base;
  for (std::uint32_t at = base.first_arc[slot]; at < base.first_arc[slot + 1]; ++at) {
    const Arc& arc = base.arcs[at];
    if (cell_of(arc.to) == block.cell) {
      improve(number, slot_of(arc.to), cost + arc.cost, number, slot);
    } else if (in_scope(arc.to)) {
      relax(arc.to, cost + arc.cost, number, slot);
    }
  }
}

void BlockSearch::leave_by(const Block& block, std::uint32_t number, std::uint32_t entry, std::uint32_t exit,
                           double cost) {
  if (cost > farthest_) return;
  exit_costs_[block.first_exit + exit] = cost;
  exit_entries_[block.first_exit + exit] = entry;
  const Overlay& overlay = *block.overlay;
  for (std::uint32_t at = overlay.first_crossing[exit]; at < overlay.first_crossing[exit + 1]; ++at) {
    const Arc& arc = overlay.crossings[at];
    if (in_scope(arc.to)) relax(arc.to, cost + arc.cost, number, exit);
  }
}

double BlockSearch::run_to(Node to) {
  // Labels move when blocks come, and the place may have none for long: it is looked up when one came.
  std::size_t blocks = 0;
  const double* found = nullptr;
  while (!heap_.empty() && (found == nullptr || heap_.front().cost < *found)) {
    settle(pop());
    if (blocks == blocks_.size()) continue;
    blocks = blocks_.size();
    found = cost_at(to);
  }
  return cost(to);
}

void BlockSearch::run() {
  while (!heap_.empty()) settle(pop());
}

double BlockSearch::cost(Node node) const {
  const double* const found = cost_at(node);
  return found == nullptr ? kFar : *found;
}

/// Returns the place's cost; null while its block has not been reached, or when it has no label there.
const double* BlockSearch::cost_at(Node node) const {
  const std::uint32_t number = known_block(node);
  if (number == kNone) return nullptr;
  const Block& block = blocks_[number];
  if (block.overlay == nullptr) return &entries_[block.first_entry + slot_of(node)].cost;
  const auto& exits = block.overlay->exits;
  const auto found = std::lower_bound(exits.begin(), exits.end(), node);
  if (found == exits.end() || *found != node) return nullptr;
  return &exit_costs_[block.first_exit + static_cast<std::size_t>(found - exits.begin())];
}

std::vector<BlockSearch::Stretch> BlockSearch::way_to(Node node) const {
  std::vector<Stretch> way;
  std::uint32_t number = known_block(node);
  if (number == kNone) return way;
  std::uint32_t slot = slot_of(node);
  if (const Overlay* const overlay = blocks_[number].overlay; overlay != nullptr) {
    const auto found = std::lower_bound(overlay->exits.begin(), overlay->exits.end(), node);
    slot = static_cast<std::uint32_t>(found - overlay->exits.begin());
  }
  while (number != kNone) {
    const Block& block = blocks_[number];
    std::uint32_t entry = slot;
    if (block.overlay == nullptr) {
      const Node here = node_at(block.cell, slot);
      way.push_back({0, block.cell, here, here, 0.0, true});
    } else {
      entry = exit_entries_[block.first_exit + slot];
      way.push_back({block.level, block.cell, block.overlay->entries[entry], block.overlay->exits[slot],
                     block.overlay->costs[entry * block.overlay->exits.size() + slot], false});
    }
    const Label& label = entries_[block.first_entry + entry];
    number = label.parent_block;
    slot = label.parent_slot;
  }
  std::reverse(way.begin(), way.end());
  return way;
}

/// Puts an entry in its place in the heap, from `at` upwards. The heap has four children a node: half as deep as with
/// two, and siblings lie side by side. What is in it rises when it gets cheaper, so that nothing is in it twice.
void BlockSearch::rise(const Entry& entry, std::size_t at) {
  while (at > 0) {
    const std::size_t parent = (at - 1) / kChildren;
    if (heap_[parent].cost <= entry.cost) break;
    heap_[at] = heap_[parent];
    heaped_[heap_[at].label] = static_cast<std::uint32_t>(at);
    at = parent;
  }
  heap_[at] = entry;
  heaped_[entry.label] = static_cast<std::uint32_t>(at);
}

BlockSearch::Entry BlockSearch::pop() {
  const Entry top = heap_.front();
  heaped_[top.label] = kNone;
  const Entry last = heap_.back();
  heap_.pop_back();
  const std::size_t size = heap_.size();
  if (size == 0) return top;
  std::size_t at = 0;
  for (std::size_t child = 1; child < size; child = kChildren * at + 1) {
    const std::size_t end = std::min(size, child + kChildren);
    std::size_t least = child;
    for (++child; child < end; ++child) {
      if (heap_[child].cost < heap_[least].cost) least = child;
    }
    if (last.cost <= heap_[least].cost) break;
    heap_[at] = heap_[least];
    heaped_[heap_[at].label] = static_cast<std::uint32_t>(at);
    at = least;
  }
  heap_[at] = last;
  heaped_[last.label] = static_cast<std::uint32_t>(at);
  return top;
}

}  // namespace weft::routing
