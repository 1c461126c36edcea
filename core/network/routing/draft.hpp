#pragma once
#include <set>

#include "core/network/routing/cells.hpp"
#include "core/network/routing/preparation.hpp"

namespace weft::routing {

/// Changes a preparation: places get nodes and lose them, cells that are marked are made anew, and what lies over
/// them as far as it changes. Private to the routing folder.
class Draft {
 public:
  explicit Draft(Preparation preparation) : made_(std::move(preparation)) {}

  const Preparation& preparation() const { return made_; }

  /// Gives the place a slot near the places that it is joined with, and marks that cell.
  void add(const PlaceId& place);
  /// Takes away the place's node, which it must have, and marks its cell.
  void remove(const PlaceId& place);
  /// Marks the base cell: it is to be joined anew.
  void mark(std::uint32_t cell) { marked_.insert(cell); }
  /// Notes that the base cell is as it must be, and its overlay is to be looked at (by its costs too, or by its
  /// borders alone).
  void look_at(std::uint32_t cell, bool costs_too);

  /// Joins a base cell that is not so far; `is_known(joined)` says whether what lies over it was made of just that,
  /// and needs its borders looked at alone.
  template <class IsKnown>
  void join(std::uint32_t cell, IsKnown&& is_known);

  /// Makes one cell; returns how many places' worth of work it was, 0 when nothing is left to be done.
  std::size_t step();
  std::size_t left_to_do() const;
  Preparation take() { return std::move(made_); }

 private:
  std::vector<Node>& nodes_of(ExperienceId experience);
  std::uint32_t room_near(const PlaceId& place);
  std::uint32_t new_cell(std::uint32_t near);
  std::size_t remake_base(std::uint32_t cell);
  std::size_t remake_overlay(std::size_t level, std::uint32_t cell);

  Preparation made_;
  std::set<std::uint32_t> marked_;
  std::array<std::set<std::uint32_t>, kLevels> stale_;
  std::array<std::set<std::uint32_t>, kLevels> changed_inside_;
  std::uint32_t newest_ = 0;  ///< base cell that the last place without neighbours went to
};

template <class IsKnown>
void Draft::join(std::uint32_t cell, IsKnown&& is_known) {
  auto base = std::make_shared<const BaseCell>(joined(made_, cell));
  look_at(cell, !is_known(*base));
  made_.base[cell] = std::move(base);
  marked_.erase(cell);
}

}  // namespace weft::routing
