#pragma once
#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace weft::agents {

/// Names a cube of a grid by its whole coordinates, each within +-2^20.
using CellCoordinates = std::array<std::int32_t, 3>;

/// Returns the cell of a point that lies `per_m` times its coordinates from the origin, in cells.
inline CellCoordinates cell_of(const Eigen::Vector3d& point, double per_m) {
  CellCoordinates cell{};
  for (unsigned axis = 0; axis < 3; ++axis) {
    const double at = point[axis] * per_m;
    cell[axis] = static_cast<std::int32_t>(at);
    if (at < cell[axis]) --cell[axis];  // std::floor is a call where the processor is not known
  }
  return cell;
}

/// Returns whether a point may be given to cell_of: finite, and no farther from the origin than cells can be named.
inline bool is_on_grid(const Eigen::Vector3d& point, double per_m) {
  constexpr double kFarthest = (1 << 20) - 2;
  const auto is_near = [&](double at) { return std::abs(at * per_m) <= kFarthest; };  // false for NaN
  return is_near(point.x()) && is_near(point.y()) && is_near(point.z());
}

/// Numbers the occupied cells of a grid, in the order in which they are first named. A hash table with open
/// addressing: grids of clouds are mostly empty.
class CellTable {
 public:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  explicit CellTable(std::size_t expected = 0);

  /// Returns the cell's number; gives it the next one when it has none.
  std::uint32_t number_of(const CellCoordinates& cell) {
    const std::uint64_t key = key_of(cell);
    if (key == last_key_) return last_number_;  // neighbours in a cloud are mostly in one cell
    last_key_ = key;
    last_number_ = insert(key, cell);
    return last_number_;
  }
  /// Returns the cell's number; kNone: it was never named.
  std::uint32_t find(const CellCoordinates& cell) const {
    const std::uint64_t key = key_of(cell);
    for (std::size_t slot = slot_of(key);; slot = (slot + 1) & mask_) {
      if (keys_[slot] == key) return numbers_[slot];
      if (keys_[slot] == 0) return kNone;
    }
  }
  const std::vector<CellCoordinates>& cells() const { return cells_; }  ///< by number
  std::size_t size() const { return cells_.size(); }

 private:
  static std::uint64_t key_of(const CellCoordinates& cell) {
    constexpr std::uint32_t kOffset = 1U << 20U;
    std::uint64_t key = 1;  // no key is 0
    for (const std::int32_t at : cell) key = key << 21U | ((static_cast<std::uint32_t>(at) + kOffset) & 0x1fffffU);
    return key;
  }
  std::size_t slot_of(std::uint64_t key) const { return (key * 0x9e3779b97f4a7c15U) >> shift_; }
  std::uint32_t insert(std::uint64_t key, const CellCoordinates& cell);
  void grow(unsigned bits);

  std::vector<std::uint64_t> keys_;     // 0: free
  std::vector<std::uint32_t> numbers_;  // of the key in the same slot
  std::vector<CellCoordinates> cells_;
  unsigned shift_ = 0;
  std::size_t mask_ = 0;
  std::uint64_t last_key_ = 0;
  std::uint32_t last_number_ = kNone;
};

}  // namespace weft::agents
