#pragma once
#include <map>
#include <utility>
#include <vector>

#include "core/network/change.hpp"
#include "core/network/goal.hpp"
#include "core/network/network.hpp"
#include "tests/bench/traffic/lanes.hpp"

namespace weft::bench {

/// Holds a network of cells as robots would have taught it: a place in the middle of each cell and three between two
/// cells, 0.35 m apart. Where a lane is driven both ways, its two ways lie 0.5 m apart.
class TaughtLanes {
 public:
  explicit TaughtLanes(const Network& network);

  static constexpr std::uint32_t kPlacesOfCell = 4;  ///< from one cell to the next

  const Snapshot& snapshot() const { return snapshot_; }
  /// Returns what makes up the network, in order: the cells, then what lies between them.
  const std::vector<Batch>& batches() const { return batches_; }
  std::size_t cells() const { return network_.size(); }
  PlaceId place(Cell cell) const { return {ExperienceId{1}, cell}; }
  /// Returns a route over those cells, each beside the one before.
  Route route(const std::vector<Cell>& cells) const;
  const Eigen::Vector2d& at(const PlaceId& place) const;

 private:
  const Network& network_;
  std::map<std::pair<Cell, Cell>, std::uint32_t> lanes_;  ///< the first place of each, of experience 2
  std::vector<Eigen::Vector2d> lane_at_;
  std::vector<Batch> batches_;
  Snapshot snapshot_;
};

}  // namespace weft::bench
