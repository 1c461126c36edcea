#include "agents/perception/sign.hpp"

#include <array>
#include <cmath>

#include "core/random.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kGroups = 16;
constexpr std::size_t kBits = 5;  // of a group: each of 32 words
constexpr std::size_t kWords = 1U << kBits;

using Groups = std::array<std::array<std::uint8_t, kBits>, kGroups>;

/// Draws which of a descriptor's 256 bits make up a word; the same for everybody, no bit twice.
Groups make_groups() {
  std::array<std::uint8_t, 256> bits{};
  for (std::size_t i = 0; i < bits.size(); ++i) bits[i] = static_cast<std::uint8_t>(i);
  Random random(0x7369676EULL);
  Groups groups{};
  std::size_t taken = 0;
  for (auto& group : groups) {
    for (std::uint8_t& bit : group) {
      std::swap(bits[taken], bits[taken + random.below(bits.size() - taken)]);
      bit = bits[taken++];
    }
  }
  return groups;
}

std::size_t word_of(const Descriptor& descriptor, const std::array<std::uint8_t, kBits>& group) {
  std::size_t word = 0;
  for (const std::uint8_t bit : group) word = word << 1U | (descriptor[bit / 64] >> (bit % 64) & 1U);
  return word;
}

}  // namespace

std::optional<std::vector<float>> sign_descriptors(std::span<const Descriptor> descriptors) {
  if (descriptors.empty()) return std::nullopt;
  static const Groups groups = make_groups();
  std::vector<float> signature(kGroups * kWords, 0.0F);
  for (const Descriptor& descriptor : descriptors) {
    for (std::size_t group = 0; group < kGroups; ++group)
      signature[group * kWords + word_of(descriptor, groups[group])] += 1.0F;
  }
  // The root makes frequent and rare words vary alike (Hellinger's distance).
  for (float& word : signature) word = std::sqrt(word / static_cast<float>(descriptors.size()));
  return signature;
}

}  // namespace weft::agents
