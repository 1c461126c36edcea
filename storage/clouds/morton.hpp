#pragma once
#include <array>
#include <cstdint>

namespace weft::clouds {

/// Moves bit i of a 21-bit number to bit 3i; the rest is zero. In steps that halve the distance bits have to go.
constexpr std::uint64_t spread_bits(std::uint64_t value) {
  value = (value | value << 32U) & 0x001f00000000ffffU;
  value = (value | value << 16U) & 0x001f0000ff0000ffU;
  value = (value | value << 8U) & 0x100f00f00f00f00fU;
  value = (value | value << 4U) & 0x10c30c30c30c30c3U;
  return (value | value << 2U) & 0x1249249249249249U;
}

/// Undoes spread_bits; bits between are ignored.
constexpr std::uint32_t gather_bits(std::uint64_t value) {
  value &= 0x1249249249249249U;
  value = (value | value >> 2U) & 0x10c30c30c30c30c3U;
  value = (value | value >> 4U) & 0x100f00f00f00f00fU;
  value = (value | value >> 8U) & 0x001f0000ff0000ffU;
  value = (value | value >> 16U) & 0x001f00000000ffffU;
  return static_cast<std::uint32_t>((value | value >> 32U) & 0x1fffffU);
}

/// Returns a cell's Morton code. Each coordinate is below 2^21.
constexpr std::uint64_t code_from_cell(const std::array<std::uint32_t, 3>& cell) {
  return spread_bits(cell[0]) | spread_bits(cell[1]) << 1U | spread_bits(cell[2]) << 2U;
}

constexpr std::array<std::uint32_t, 3> cell_from_code(std::uint64_t code) {
  return {gather_bits(code), gather_bits(code >> 1U), gather_bits(code >> 2U)};
}

}  // namespace weft::clouds
