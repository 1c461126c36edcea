#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

namespace weft::clouds {

/// Sorts by `code_of(entry)`, a u64, keeping the order of equal ones: counting passes over 11 bits at a time, from
/// the lowest (LSD radix sort), as many as the largest code needs. All passes are counted in one reading.
template <class Entry, class CodeOf>
void radix_sort(std::vector<Entry>& entries, CodeOf code_of) {
  constexpr unsigned kDigitBits = 11;
  constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;
  std::uint64_t all_bits = 0;
  for (const Entry& entry : entries) all_bits |= code_of(entry);
  const unsigned passes = (static_cast<unsigned>(std::bit_width(all_bits)) + kDigitBits - 1) / kDigitBits;
  std::vector<std::array<std::uint32_t, kDigits>> starts(passes);
  for (const Entry& entry : entries) {
    std::uint64_t code = code_of(entry);
    for (auto& counts : starts) {
      ++counts[code % kDigits];
      code >>= kDigitBits;
    }
  }
  std::vector<Entry> sorted(entries.size());
  for (unsigned pass = 0; pass < passes; ++pass) {
    std::uint32_t start = 0;
    for (std::uint32_t& slot : starts[pass]) start += std::exchange(slot, start);
    for (const Entry& entry : entries) {
      sorted[starts[pass][(code_of(entry) >> (pass * kDigitBits)) % kDigits]++] = entry;
    }
    entries.swap(sorted);
  }
}

}  // namespace weft::clouds
