#pragma once
#include <array>
#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace weft {

/// Reads eight bytes as a number that sorts as they do.
inline std::uint64_t big_endian(const std::uint8_t* bytes) {
  std::uint64_t number = 0;
  for (int i = 0; i < 8; ++i) number = (number << 8U) | bytes[i];
  return number;
}

/// Holds N opaque bytes with a type of their own. All zero means "none".
template <class Tag, std::size_t N>
struct ByteId {
  std::array<std::uint8_t, N> bytes{};
  bool operator==(const ByteId&) const = default;
  /// Compares byte by byte; eight at once, as maps of these are searched a lot.
  friend std::strong_ordering operator<=>(const ByteId& a, const ByteId& b) {
    static_assert(N % sizeof(std::uint64_t) == 0);
    for (std::size_t at = 0; at < N; at += sizeof(std::uint64_t)) {
      const std::uint64_t of_a = big_endian(a.bytes.data() + at);
      const std::uint64_t of_b = big_endian(b.bytes.data() + at);
      if (of_a != of_b) return of_a <=> of_b;
    }
    return std::strong_ordering::equal;
  }
  explicit operator bool() const { return *this != ByteId{}; }
};

/// Holds a counter with a type of its own.
template <class Tag>
struct Counter {
  std::uint64_t value = 0;
  auto operator<=>(const Counter&) const = default;
};

using PeerId = ByteId<struct PeerTag, 16>;  ///< any process on the wire; random, kept in its state directory
using RobotId = PeerId;                     ///< the peer id of a robot's agent
using GoalId = ByteId<struct GoalTag, 16>;
using RouteId = ByteId<struct RouteTag, 16>;
using ContentHash = ByteId<struct ContentTag, 32>;  ///< SHA-256 of canonical uncompressed bytes
using Digest = ByteId<struct DigestTag, 32>;        ///< SHA-256 over a window's entities

using Epoch = Counter<struct EpochTag>;        ///< one more at every server start
using Revision = Counter<struct RevisionTag>;  ///< one more at every committed group of changes; 0: the empty network

/// Holds random 64 bits, drawn by the robot whose run it is. 0 means "none".
struct ExperienceId {
  std::uint64_t value = 0;
  auto operator<=>(const ExperienceId&) const = default;
  explicit operator bool() const { return value != 0; }
};

/// Identifies the index-th place of an experience, counted from 0 without gaps.
struct PlaceId {
  ExperienceId experience;
  std::uint32_t index = 0;
  auto operator<=>(const PlaceId&) const = default;
  explicit operator bool() const { return bool(experience); }
};

/// Return the id as lower-case hex; places are "<16 hex>:<index>".
template <class Tag, std::size_t N>
std::string to_string(const ByteId<Tag, N>& id) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string text;
  for (const std::uint8_t byte : id.bytes) {
    text += digits[byte >> 4U];
    text += digits[byte & 15U];
  }
  return text;
}
std::string to_string(ExperienceId id);
std::string to_string(const PlaceId& id);
std::optional<PlaceId> parse_place_id(std::string_view text);
std::optional<ExperienceId> parse_experience_id(std::string_view text);
/// Fills `out` from exactly 2 * size hex digits; false on anything else.
bool parse_hex(std::string_view text, std::uint8_t* out, std::size_t size);

}  // namespace weft
