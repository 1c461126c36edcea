#pragma once
#include <bit>
#include <concepts>
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
    for (unsigned shift = 0; shift < 8 * sizeof(U); shift += 8) {
      bytes_.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(value) >> shift));
    }
  }
  void i64(std::int64_t value) { number(static_cast<std::uint64_t>(value)); }
  void f32(float value) { number(std::bit_cast<std::uint32_t>(value)); }
  void f64(double value) { number(std::bit_cast<std::uint64_t>(value)); }
  void flag(bool value) { number(static_cast<std::uint8_t>(value ? 1 : 0)); }
  void count(std::size_t value) { number(static_cast<std::uint32_t>(value)); }
  void raw(ByteView bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }
  /// Length in four bytes, then the bytes.
  void text(std::string_view value) {
    count(value.size());
    bytes_.insert(bytes_.end(), value.begin(), value.end());
  }
  template <class Tag, std::size_t N>
  void id(const ByteId<Tag, N>& value) {
    raw(value.bytes);
  }
  void id(const PlaceId& value) {
    number(value.experience.value);
    number(value.index);
  }

  Bytes take() { return std::move(bytes_); }
  ByteView view() const { return bytes_; }

 private:
  Bytes bytes_;
};

}  // namespace weft
