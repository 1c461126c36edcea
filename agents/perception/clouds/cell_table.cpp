#include "agents/perception/clouds/cell_table.hpp"

#include <bit>

namespace weft::agents {

CellTable::CellTable(std::size_t expected) {
  constexpr unsigned kLeastBits = 6;
  const auto bits = static_cast<unsigned>(std::bit_width(2 * expected));
  grow(bits < kLeastBits ? kLeastBits : bits);
  cells_.reserve(expected);
}

std::uint32_t CellTable::insert(std::uint64_t key, const CellCoordinates& cell) {
  std::size_t slot = slot_of(key);
  while (keys_[slot] != 0) {
    if (keys_[slot] == key) return numbers_[slot];
    slot = (slot + 1) & mask_;
  }
  const auto number = static_cast<std::uint32_t>(cells_.size());
  keys_[slot] = key;
  numbers_[slot] = number;
  cells_.push_back(cell);
  if (2 * cells_.size() > keys_.size()) grow(static_cast<unsigned>(std::bit_width(keys_.size())));
  return number;
}

/// Makes room for 2^bits slots and puts every cell into its new one.
void CellTable::grow(unsigned bits) {
  keys_.assign(std::size_t{1} << bits, 0);
  numbers_.assign(keys_.size(), kNone);
  mask_ = keys_.size() - 1;
  shift_ = 64 - bits;
  for (std::uint32_t number = 0; number < cells_.size(); ++number) {
    const std::uint64_t key = key_of(cells_[number]);
    std::size_t slot = slot_of(key);
    while (keys_[slot] != 0) slot = (slot + 1) & mask_;
    keys_[slot] = key;
    numbers_[slot] = number;
  }
}

}  // namespace weft::agents
