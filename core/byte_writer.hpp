#pragma once
#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "core/bytes.hpp"
#include "core/ids.hpp"

namespace weft {

/// Appends little-endian fields, without padding.
class ByteWriter {
 public:
  template <std::unsigned_integral U>
  void number(U value) {
    std::array<std::uint8_t, sizeof(U)> little{};
    for (std::size_t i = 0; i < sizeof(U); ++i) {
      little[i] = static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> (8 * i));
    }
    raw(little);
  }
  void i64(std::int64_t value) { number(static_cast<std::uint64_t>(value)); }
  void f32(float value) { number(std::bit_cast<std::uint32_t>(value)); }
  void f64(double value) { number(std::bit_cast<std::uint64_t>(value)); }
  void flag(bool value) { number(static_cast<std::uint8_t>(value ? 1 : 0)); }
  void count(std::size_t value) { number(static_cast<std::uint32_t>(value)); }
  void raw(ByteView bytes) {
    const std::size_t end = bytes_.size();
    bytes_.resize(end + bytes.size());
    std::copy(bytes.begin(), bytes.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(end));
  }
  /// Appends the length in four bytes, then the bytes.
  void text(std::string_view value) {
    count(value.size());
    raw({reinterpret_cast<const std::uint8_t*>(value.data()), value.size()});
  }
  template <class Tag, std::size_t N>
  void id(const ByteId<Tag, N>& value) {
    raw(value.bytes);
  }
  void id(const PlaceId& value) {
    number(value.experience.value);
    number(value.index);
  }

  void reserve(std::size_t size) { bytes_.reserve(size); }
  /// Empties it; its memory stays for what comes next.
  void clear() { bytes_.clear(); }
  Bytes take() { return std::move(bytes_); }
  ByteView view() const { return bytes_; }

 private:
  Bytes bytes_;
};

}  // namespace weft
