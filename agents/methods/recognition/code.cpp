#include "agents/methods/recognition/code.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace weft::agents {
namespace {

constexpr std::size_t kLanes = 16;
constexpr std::size_t kPerByte = 4;
constexpr double kStep = 0.9816;  // of the standard deviation: the best four levels of a normal number (Max 1960)
constexpr double kWidest = 3.0;   // standard deviations; farther ones count as that
constexpr double kScale = 100.0 / kWidest;
// A lane sums up 4 products of at most 3 * 100 a block: 16 blocks of 16 bytes stay below 2^15.
static_assert(longest_signature / (kPerByte * kLanes) * kPerByte * 3 * 100 < 32'768);

struct Moments {
  double mean = 0.0;
  double deviation = 1.0;
};

Moments moments_of(const Signature& signature) {
  Moments moments;
  for (const float number : signature) moments.mean += static_cast<double>(number);
  moments.mean /= static_cast<double>(std::max<std::size_t>(1, signature.size()));
  double square = 0.0;
  for (const float number : signature) square += std::pow(static_cast<double>(number) - moments.mean, 2);
  if (square > 0.0) moments.deviation = std::sqrt(square / static_cast<double>(signature.size()));
  return moments;
}

/// Number i stands in byte i % bytes, at the pair of bits i / bytes.
[[gnu::always_inline]] inline std::int32_t correlate(const std::int16_t* weights, const std::uint8_t* code,
                                                     std::size_t bytes) {
  std::array<std::int16_t, kLanes> sums{};
  for (std::size_t at = 0; at < bytes; at += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const std::uint8_t four = code[at + lane];
      const std::int16_t* const weight = weights + at + lane;
      sums[lane] = static_cast<std::int16_t>(sums[lane] + weight[0] * (four & 3) + weight[bytes] * (four >> 2 & 3) +
                                             weight[2 * bytes] * (four >> 4 & 3) + weight[3 * bytes] * (four >> 6));
    }
  }
  std::int32_t sum = 0;
  for (const std::int16_t lane : sums) sum += lane;
  return sum;
}

void compare_plain(const std::int16_t* weights, const std::uint8_t* codes, std::size_t bytes,
                   std::span<std::int32_t> likeness) {
  for (std::size_t i = 0; i < likeness.size(); ++i) likeness[i] = correlate(weights, codes + i * bytes, bytes);
}

#if defined(__x86_64__)
__attribute__((target("avx2"))) void compare_avx2(const std::int16_t* weights, const std::uint8_t* codes,
                                                  std::size_t bytes, std::span<std::int32_t> likeness) {
  for (std::size_t i = 0; i < likeness.size(); ++i) likeness[i] = correlate(weights, codes + i * bytes, bytes);
}
#endif

}  // namespace

std::size_t code_bytes(std::size_t numbers) {
  return (numbers + kPerByte * kLanes - 1) / (kPerByte * kLanes) * kLanes;
}

void write_code(const Signature& signature, std::span<std::uint8_t> code) {
  const Moments own = moments_of(signature);
  std::fill(code.begin(), code.end(), std::uint8_t{0});
  for (std::size_t i = 0; i < signature.size(); ++i) {
    const double off = (static_cast<double>(signature[i]) - own.mean) / own.deviation;
    const unsigned level = off < -kStep ? 0U : off < 0.0 ? 1U : off < kStep ? 2U : 3U;
    std::uint8_t& byte = code[i % code.size()];
    byte = static_cast<std::uint8_t>(byte | level << 2U * (i / code.size()));
  }
}

CodeQuery::CodeQuery(const Signature& seen)
    : bytes_(code_bytes(seen.size())), weights_(kPerByte * code_bytes(seen.size()), 0) {
  const Moments own = moments_of(seen);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double off = (static_cast<double>(seen[i]) - own.mean) / own.deviation;
    weights_[i] = static_cast<std::int16_t>(std::lround(kScale * std::clamp(off, -kWidest, kWidest)));
  }
}

void CodeQuery::compare(std::span<const std::uint8_t> codes, std::span<std::int32_t> likeness) const {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return compare_avx2(weights_.data(), codes.data(), bytes_, likeness);
#endif
  compare_plain(weights_.data(), codes.data(), bytes_, likeness);
}

}  // namespace weft::agents
