#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/flat_map.hpp"
#include "core/network/network.hpp"

namespace weft::routing {

/// Stands for a place as a number: its base cell, and its slot there in the low bits.
using Node = std::uint32_t;
inline constexpr Node kNoNode = std::numeric_limits<Node>::max();
inline constexpr std::uint32_t kSlotBits = 10;
inline constexpr std::uint32_t cell_of(Node node) {
  return node >> kSlotBits;
}
inline constexpr std::uint32_t slot_of(Node node) {
  return node & ((1U << kSlotBits) - 1U);
}
inline constexpr Node node_at(std::uint32_t cell, std::uint32_t slot) {
  return (cell << kSlotBits) | slot;
}

/// Set how many levels of cells lie in one another, level 0 being the base, and the most places of a cell when the
/// preparation is made; one that grows by changes may come to hold more.
inline constexpr std::size_t kLevels = 4;
inline constexpr std::array<std::uint32_t, kLevels> kCellPlaces{128, 1024, 8192, 65536};
inline constexpr std::uint32_t kBaseRoom = 400;     ///< slots of a base cell that changes may fill
inline constexpr std::uint32_t kMostChildren = 24;  ///< cells that changes may bring into a cell of the next level

/// Describes a drivable edge in the direction of travel; the cost is the norm of its relation.
struct Arc {
  Node to = kNoNode;
  double cost = 0.0;
  bool operator==(const Arc&) const = default;
};

/// Holds places near one another, with what leads out of each.
struct BaseCell {
  std::vector<PlaceId> places;  ///< by slot; no experience: nothing is there (any more)
  std::vector<std::uint32_t> first_arc;
  std::vector<Arc> arcs;
  /// Count the levels, 0 to kLevels, in which an arc that enters (or leaves) the slot's place crosses its cell's
  /// border.
  std::vector<std::uint8_t> entered;
  std::vector<std::uint8_t> left;
  bool operator==(const BaseCell&) const = default;
};

/// Holds the costs of driving through a cell: from each place where one can come in to each where one can go out, on
/// ways that stay within. It is the overlay of Delling, Goldberg, Pajor, Werneck, "Customizable Route Planning in
/// Road Networks" (2017), section 3.
struct Overlay {
  std::vector<std::uint32_t> children;        ///< cells one level below; none at level 0
  std::vector<Node> entries;                  ///< ascending
  std::vector<Node> exits;                    ///< ascending
  std::vector<double> costs;                  ///< entry by entry; infinity: no way within the cell
  std::vector<std::uint32_t> first_crossing;  ///< of each exit in `crossings`, and their number
  std::vector<Arc> crossings;                 ///< arcs that leave the cell
  bool operator==(const Overlay&) const = default;
};

/// Holds a network made ready for the search of routes with one set of methods. An immutable value; preparations of
/// neighbouring revisions share what is the same.
struct Preparation {
  Snapshot of;                    ///< the network that it answers for
  std::set<std::string> methods;  ///< edges of other methods are not in it
  std::vector<std::shared_ptr<const BaseCell>> base;
  std::array<std::vector<std::shared_ptr<const Overlay>>, kLevels> overlays;  ///< by level and cell
  std::vector<std::array<std::uint32_t, kLevels>> cells;  ///< of each base cell: the cell of each level it lies in
  FlatMap<ExperienceId, std::shared_ptr<const std::vector<Node>>>
      nodes;  ///< by the index of the place; kNoNode: none

  Node node(const PlaceId& place) const;
  const PlaceId& place(Node node) const { return base[cell_of(node)]->places[slot_of(node)]; }
  std::uint32_t cell(Node node, std::size_t level) const { return cells[cell_of(node)][level]; }
};

/// Returns the size in memory, without the network itself.
std::size_t size_bytes(const Preparation& preparation);

}  // namespace weft::routing
