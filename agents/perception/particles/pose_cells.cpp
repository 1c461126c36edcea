#include "agents/perception/particles/pose_cells.hpp"

#include <bit>

namespace weft::agents {

CellNumbers::CellNumbers(std::size_t most) : slots_(std::bit_ceil(2 * most + 2), kNone) {
  cells_.reserve(most);
}

std::size_t CellNumbers::slot_of(const PoseCell& cell) const {
  std::uint64_t mixed = static_cast<std::uint32_t>(cell.column);
  mixed = mixed * 0x9e3779b97f4a7c15ULL + static_cast<std::uint32_t>(cell.row);
  mixed = mixed * 0x9e3779b97f4a7c15ULL + static_cast<std::uint32_t>(cell.turn);
  mixed ^= mixed >> 32U;
  mixed *= 0xbf58476d1ce4e5b9ULL;
  mixed ^= mixed >> 29U;
  std::size_t slot = mixed & (slots_.size() - 1);
  while (slots_[slot] != kNone && !(cells_[slots_[slot]] == cell)) slot = (slot + 1) & (slots_.size() - 1);
  return slot;
}

std::size_t CellNumbers::number(const PoseCell& cell) {
  std::size_t& found = slots_[slot_of(cell)];
  if (found == kNone) {
    found = cells_.size();
    cells_.push_back(cell);
  }
  return found;
}

std::size_t CellNumbers::find(const PoseCell& cell) const {
  return slots_[slot_of(cell)];
}

}  // namespace weft::agents
