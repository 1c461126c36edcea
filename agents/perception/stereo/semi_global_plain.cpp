#include <cstdint>

#include "agents/perception/stereo/semi_global.hpp"

namespace weft::agents::semi_global {
namespace plain {
namespace {

/// Holds 32 bytes, one a lane.
struct Bytes {
  std::uint8_t lane[kLanes] = {};
};

template <class Of>
[[gnu::always_inline]] inline Bytes each_lane(Of&& of) {
  Bytes result;
  for (int i = 0; i < kLanes; ++i) result.lane[i] = static_cast<std::uint8_t>(of(i));
  return result;
}

[[gnu::always_inline]] inline Bytes load(const std::uint8_t* from) {
  Bytes bytes;
  __builtin_memcpy(bytes.lane, from, sizeof bytes);
  return bytes;
}

[[gnu::always_inline]] inline void store(std::uint8_t* to, const Bytes& bytes) {
  __builtin_memcpy(to, bytes.lane, sizeof bytes);
}

[[gnu::always_inline]] inline Bytes everywhere(std::uint8_t value) {
  return each_lane([&](int) { return value; });
}

[[gnu::always_inline]] inline Bytes counting() {
  return each_lane([](int i) { return i; });
}

[[gnu::always_inline]] inline Bytes plus(const Bytes& a, const Bytes& b) {
  return each_lane([&](int i) { return a.lane[i] + b.lane[i] < 255 ? a.lane[i] + b.lane[i] : 255; });
}

[[gnu::always_inline]] inline Bytes minus(const Bytes& a, const Bytes& b) {
  return each_lane([&](int i) { return a.lane[i] > b.lane[i] ? a.lane[i] - b.lane[i] : 0; });
}

[[gnu::always_inline]] inline Bytes lesser(const Bytes& a, const Bytes& b) {
  return each_lane([&](int i) { return a.lane[i] < b.lane[i] ? a.lane[i] : b.lane[i]; });
}

[[gnu::always_inline]] inline Bytes either(const Bytes& a, const Bytes& b) {
  return each_lane([&](int i) { return a.lane[i] | b.lane[i]; });
}

/// Returns the bytes one lane further up; the last one of `before` comes in below.
[[gnu::always_inline]] inline Bytes lanes_up(const Bytes& bytes, const Bytes& before) {
  return each_lane([&](int i) { return i > 0 ? bytes.lane[i - 1] : before.lane[kLanes - 1]; });
}

/// Returns the bytes one lane further down; the first one of `after` comes in above.
[[gnu::always_inline]] inline Bytes lanes_down(const Bytes& bytes, const Bytes& after) {
  return each_lane([&](int i) { return i + 1 < kLanes ? bytes.lane[i + 1] : after.lane[0]; });
}

/// Returns the least lane's value in all lanes.
[[gnu::always_inline]] inline Bytes least_lane(const Bytes& bytes) {
  std::uint8_t least = bytes.lane[0];
  for (int i = 1; i < kLanes; ++i) least = bytes.lane[i] < least ? bytes.lane[i] : least;
  return everywhere(least);
}

[[gnu::always_inline]] inline std::uint8_t first_lane(const Bytes& bytes) {
  return bytes.lane[0];
}

/// Returns a bit for each lane in which the two are equal.
[[gnu::always_inline]] inline std::uint32_t lanes_equal(const Bytes& a, const Bytes& b) {
  std::uint32_t bits = 0;
  for (int i = 0; i < kLanes; ++i) bits |= static_cast<std::uint32_t>(a.lane[i] == b.lane[i]) << i;
  return bits;
}

/// Returns `then` where a and b are equal, else `otherwise`.
[[gnu::always_inline]] inline Bytes where_equal(const Bytes& a, const Bytes& b, const Bytes& then,
                                                const Bytes& otherwise) {
  return each_lane([&](int i) { return a.lane[i] == b.lane[i] ? then.lane[i] : otherwise.lane[i]; });
}

/// Returns how many of four bits differ.
[[gnu::always_inline]] inline Bytes bits_that_differ(const Bytes& a, const Bytes& b) {
  return each_lane([&](int i) { return __builtin_popcount(static_cast<unsigned>(a.lane[i] ^ b.lane[i])); });
}

#include "agents/perception/stereo/semi_global_body.hpp"

}  // namespace

void match_row(const Row& row) {
  match(row);
}

}  // namespace plain

MatchRow match_row() {
  return __builtin_cpu_supports("avx2") ? avx2::match_row : plain::match_row;
}

}  // namespace weft::agents::semi_global
