#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace weft::agents {

/// Holds 256 comparisons of grey values around a keypoint (Rublee et al. 2011, ORB).
using Descriptor = std::array<std::uint64_t, 4>;

int hamming(const Descriptor& a, const Descriptor& b);
/// Writes the distance from `from` to `to[which[k]]`, bits, into `out[k]`; several times as fast as one by one.
void hamming(const Descriptor& from, std::span<const Descriptor> to, std::span<const std::uint32_t> which,
             std::vector<std::uint16_t>& out);

/// Pairs, by index, two descriptors that are each other's nearest.
struct Match {
  std::uint32_t a = 0;
  std::uint32_t b = 0;
  int distance = 0;  ///< bits
};

struct MatchBounds {
  int most_bits = 72;  ///< [0, 256]
  double ratio = 0.9;  ///< (0, 1]: of the best to the second best candidate
};

/// Return matches within `bounds`, best first. `candidates_of_b[j]`: indices of a that b[j] may be; without it, all.
std::vector<Match> match_descriptors(std::span<const Descriptor> a, std::span<const Descriptor> b,
                                     const MatchBounds& bounds);
std::vector<Match> match_descriptors(std::span<const Descriptor> a, std::span<const Descriptor> b,
                                     const MatchBounds& bounds,
                                     const std::vector<std::vector<std::uint32_t>>& candidates_of_b);

}  // namespace weft::agents
