#pragma once
#include <array>
#include <vector>

#include "core/network/routing/preparation.hpp"

namespace weft::routing {

/// Searches by Dijkstra's algorithm over cells: a cell is passed from entry to exit in one step, except those that
/// are opened, which are gone through place by place. One object serves many searches one after the other.
class BlockSearch {
 public:
  /// Refers to the preparation, which must outlive it.
  explicit BlockSearch(const Preparation& preparation);

  /// Confines the following searches to this cell, each of whose child cells is crossed in one step.
  void confine(std::size_t level, std::uint32_t cell);
  /// Lets the following searches cover the whole network; the cells that hold either node are opened.
  void search_all(Node from, Node to);

  /// Forgets the last search and begins at a place. Nothing beyond `farthest` is of interest.
  void start(Node from, double farthest = std::numeric_limits<double>::infinity());
  /// Searches until the place is reached; returns its least cost, infinity when it cannot be reached.
  double run_to(Node to);
  /// Searches until everything within reach is settled.
  void run();
  /// Returns the least cost to a place that lies in an opened cell or is an exit of its block; infinity: not reached.
  double cost(Node node) const;

  /// Describes a stretch of the way: within a cell from entry to exit, or (open) one place.
  struct Stretch {
    std::size_t level = 0;
    std::uint32_t cell = 0;
    Node from = kNoNode;
    Node to = kNoNode;
    double cost = 0.0;
    bool is_open = false;
  };
  /// Returns the way to a place that was reached, from the start on.
  std::vector<Stretch> way_to(Node node) const;

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
  static constexpr std::size_t kOpen = kLevels;  ///< in place of a level: gone through place by place

  struct Where {
    std::size_t level;
    std::uint32_t cell;
  };
  struct Block {
    std::size_t level;
    std::uint32_t cell;
    std::uint32_t first_entry;  ///< of its labels
    std::uint32_t first_exit;
    const Overlay* overlay;  ///< null: open
    const BaseCell* base;    ///< of an open one
  };
  struct Label {
    double cost;
    std::uint32_t parent_block;
    std::uint32_t parent_slot;  ///< an exit of the parent, or a slot of an open one
  };
  struct Entry {
    double cost;
    std::uint32_t block;
    std::uint32_t label;  ///< in `entries_`
  };

  bool in_scope(Node node) const {
    if (level_ == 0) return cell_of(node) == cell_;  // most often asked, and without looking anything up
    return level_ == kLevels || preparation_.cell(node, level_) == cell_;
  }
  bool is_opened(std::size_t level, std::uint32_t cell) const {
    return opens_ && (cell == opened_[0][level] || cell == opened_[1][level]);
  }
  Where where(Node node) const;
  std::uint32_t block_of(Where at);
  std::uint32_t new_block(Where at);
  std::uint32_t known_block(Node node) const;
  std::uint32_t slot_in(const Block& block, Node node) const;
  const double* cost_at(Node node) const;
  void relax(Node node, double cost, std::uint32_t parent_block, std::uint32_t parent_slot);
  void improve(std::uint32_t block, std::uint32_t slot, double cost, std::uint32_t parent_block,
               std::uint32_t parent_slot);
  void settle(const Entry& entry);
  void settle_open(const Block& block, std::uint32_t number, std::uint32_t slot, double cost);
  void leave_by(const Block& block, std::uint32_t number, std::uint32_t entry, std::uint32_t exit, double cost);
  void rise(const Entry& entry, std::size_t at);
  Entry pop();

  const Preparation& preparation_;
  std::size_t level_ = kLevels;  ///< kLevels: no bounds
  std::uint32_t cell_ = 0;
  bool opens_ = false;
  std::array<std::array<std::uint32_t, kLevels>, 2> opened_{};
  std::array<std::vector<std::uint32_t>, kLevels + 1> blocks_at_;
  std::vector<Block> blocks_;
  std::vector<Label> entries_;
  std::vector<std::uint32_t> heaped_;  ///< of each of `entries_`: where it is in the heap
  std::vector<double> exit_costs_;
  std::vector<std::uint32_t> exit_entries_;  ///< through which of the block's entries it is left at that cost
  std::vector<Entry> heap_;
  double farthest_ = std::numeric_limits<double>::infinity();
};

}  // namespace weft::routing
