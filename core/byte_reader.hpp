#pragma once
#include <algorithm>
#include <bit>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/bytes.hpp"
#include "core/ids.hpp"
#include "core/result.hpp"

namespace weft {

/// Reads little-endian fields and never past the end. The first thing wrong sticks: from then on every read gives
/// zeros, and `finish` says which field it was and where. Field names are static text.
class ByteReader {
 public:
  explicit ByteReader(ByteView bytes) : bytes_(bytes) {}

  template <std::unsigned_integral U>
  U number(const char* field) {
    std::uint64_t value = 0;
    const ByteView taken = take(field, sizeof(U));
    for (std::size_t i = 0; i < taken.size(); ++i) value |= static_cast<std::uint64_t>(taken[i]) << (8 * i);
    return static_cast<U>(value);
  }
  std::int64_t i64(const char* field) { return static_cast<std::int64_t>(number<std::uint64_t>(field)); }
  float f32(const char* field) { return std::bit_cast<float>(number<std::uint32_t>(field)); }
  double f64(const char* field) { return std::bit_cast<double>(number<std::uint64_t>(field)); }
  bool flag(const char* field) { return ranged<std::uint8_t>(field, 0, 1) == 1; }
  /// Reads a number that must lie in [low, high].
  template <std::unsigned_integral U>
  U ranged(const char* field, U low, U high) {
    const std::size_t at = offset_;
    const U value = number<U>(field);
    if (ok() && (value < low || value > high)) {
      corrupt(
          field, at,
          "is " + std::to_string(value) + ", must be in [" + std::to_string(low) + ", " + std::to_string(high) + "]");
    }
    return ok() ? value : low;
  }
  /// Reads how many entries follow. corrupt: more than the remaining bytes can hold at `least_bytes` each.
  std::size_t count(const char* field, std::size_t least_bytes) {
    const std::size_t at = offset_;
    const std::size_t value = number<std::uint32_t>(field);
    if (value > (bytes_.size() - offset_) / std::max<std::size_t>(1, least_bytes)) {
      corrupt(field, at, "counts " + std::to_string(value) + " entries, more than the bytes that follow can hold");
    }
    return ok() ? value : 0;
  }
  std::string text(const char* field) {
    const ByteView taken = take(field, count(field, 1));
    return {taken.begin(), taken.end()};
  }
  template <class Id>
  Id id(const char* field) {
    Id value;
    const ByteView taken = take(field, value.bytes.size());
    std::copy(taken.begin(), taken.end(), value.bytes.begin());
    return value;
  }
  PlaceId place_id(const char* field) {
    const ExperienceId experience{number<std::uint64_t>(field)};
    return {experience, number<std::uint32_t>(field)};
  }

  void corrupt(const char* field, std::size_t offset, const std::string& what) {
    if (ok()) error_ = std::string(field) + " at byte " + std::to_string(offset) + " " + what;
  }
  bool ok() const { return error_.empty(); }
  std::size_t offset() const { return offset_; }

  /// Ends the reading of the record that `what` names. corrupt: the first thing wrong, or bytes that are left over.
  Result<void> finish(const char* what) {
    if (ok() && offset_ != bytes_.size()) {
      error_ = std::to_string(bytes_.size() - offset_) + " bytes are left over at byte " + std::to_string(offset_);
    }
    if (ok()) return {};
    return fail(ErrorCode::corrupt, std::string(what) + ": " + error_);
  }

 private:
  ByteView take(const char* field, std::size_t size) {
    if (!ok()) return {};
    if (size > bytes_.size() - offset_) {
      corrupt(field, offset_,
              "needs " + std::to_string(size) + " bytes, " + std::to_string(bytes_.size() - offset_) + " are there");
      return {};
    }
    const ByteView taken = bytes_.subspan(offset_, size);
    offset_ += size;
    return taken;
  }

  ByteView bytes_;
  std::size_t offset_ = 0;
  std::string error_;
};

}  // namespace weft
