#include "agents/methods/recognition/code.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace weft::agents {
namespace {

constexpr std::size_t kLanes = 16;
constexpr std::size_t kPerByte = 2;
constexpr int kLevels = 16;
constexpr double kStep = 0.5;  // standard deviations a level
constexpr double kMiddle = 0.5 * (kLevels - 1);
constexpr int kWeight = 34;  // of what lies farthest from what is usual
constexpr int kWeightOfALevel = 8;
// A lane sums up 2 products a block: the blocks of the longest signature stay below 2^15.
static_assert(longest_signature / (kPerByte * kLanes) * kPerByte * (kLevels - 1) * kWeight < 32'768);

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

/// Returns how far a number is from the middle, in levels.
double off(float number, const Moments& own) {
  return (static_cast<double>(number) - own.mean) / own.deviation / kStep;
}

/// Correlates weights with a code, whose number i stands in byte i % bytes, in its lower half for i < bytes, else in
/// its upper half.
[[gnu::always_inline]] inline std::int32_t correlate(const std::int16_t* weights, const std::uint8_t* code,
                                                     std::size_t bytes) {
  std::array<std::int16_t, kLanes> sums{};
  for (std::size_t at = 0; at < bytes; at += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const std::uint8_t two = code[at + lane];
      const std::int16_t* const weight = weights + at + lane;
      sums[lane] = static_cast<std::int16_t>(sums[lane] + weight[0] * (two & 15) + weight[bytes] * (two >> 4));
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
    const double level = std::floor(off(signature[i], own) + kMiddle + 0.5);
    std::uint8_t& byte = code[i % code.size()];
    const auto bits = static_cast<unsigned>(std::clamp(level, 0.0, kLevels - 1.0));
    byte = static_cast<std::uint8_t>(byte | bits << 4U * (i / code.size()));
  }
}

void UsualLevels::count(std::span<const std::uint8_t> code, int times) {
  sums_.resize(kPerByte * code.size());
  for (std::size_t i = 0; i < code.size(); ++i) {
    sums_[i] += times * (code[i] & 15);
    sums_[i + code.size()] += times * (code[i] >> 4);
  }
  codes_ += times;
}

double UsualLevels::of(std::size_t number) const {
  return codes_ > 0 ? static_cast<double>(sums_[number]) / static_cast<double>(codes_) : kMiddle;
}

CodeQuery::CodeQuery(const Signature& seen, const UsualLevels& usual)
    : bytes_(code_bytes(seen.size())), weights_(kPerByte * code_bytes(seen.size()), 0) {
  const Moments own = moments_of(seen);
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const double unusual = off(seen[i], own) + kMiddle - usual.of(i);
    const auto weight = std::lround(std::clamp(kWeightOfALevel * unusual, -1.0 * kWeight, 1.0 * kWeight));
    weights_[i] = static_cast<std::int16_t>(weight);
  }
}

void CodeQuery::compare(std::span<const std::uint8_t> codes, std::span<std::int32_t> likeness) const {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return compare_avx2(weights_.data(), codes.data(), bytes_, likeness);
#endif
  compare_plain(weights_.data(), codes.data(), bytes_, likeness);
}

}  // namespace weft::agents
