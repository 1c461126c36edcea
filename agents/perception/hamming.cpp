#include "agents/perception/hamming.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace weft::agents {
namespace {

struct Nearest {
  std::uint32_t index = 0;
  int best = 257;
  int second = 257;

  void offer(std::uint32_t candidate, int distance) {
    if (distance < best) {
      second = best;
      best = distance;
      index = candidate;
    } else {
      second = std::min(second, distance);
    }
  }
};

// Plain -O2 counts bits by table, 6.5 times slower; the instruction is chosen where the machine has it.
#if defined(__x86_64__)
__attribute__((target("popcnt"))) void distances_popcnt(const Descriptor& from, std::span<const Descriptor> to,
                                                        std::span<const std::uint32_t> which, std::uint16_t* out) {
  for (const std::uint32_t i : which)
    *out++ = static_cast<std::uint16_t>(
        __builtin_popcountll(from[0] ^ to[i][0]) + __builtin_popcountll(from[1] ^ to[i][1]) +
        __builtin_popcountll(from[2] ^ to[i][2]) + __builtin_popcountll(from[3] ^ to[i][3]));
}
#endif

std::vector<Match> mutual(const std::vector<Nearest>& of_a, const std::vector<Nearest>& of_b,
                          const MatchBounds& bounds) {
  std::vector<Match> matches;
  for (std::uint32_t j = 0; j < of_b.size(); ++j) {
    const Nearest& n = of_b[j];
    if (n.best > bounds.most_bits || n.best > bounds.ratio * n.second || of_a[n.index].index != j) continue;
    matches.push_back({n.index, j, n.best});
  }
  std::stable_sort(matches.begin(), matches.end(),
                   [](const Match& x, const Match& y) { return x.distance < y.distance; });
  return matches;
}

/// Returns the mutual matches among pairs that may be one point. `candidates(j)`: indices of a that b[j] may be.
template <class Candidates>
std::vector<Match> match_among(std::span<const Descriptor> a, std::span<const Descriptor> b,
                               const MatchBounds& bounds, const Candidates& candidates) {
  std::vector<Nearest> of_a(a.size());
  std::vector<Nearest> of_b(b.size());
  std::vector<std::uint16_t> distances;
  for (std::uint32_t j = 0; j < b.size(); ++j) {
    const std::span<const std::uint32_t> which = candidates(j);
    hamming(b[j], a, which, distances);
    for (std::size_t k = 0; k < which.size(); ++k) {
      of_b[j].offer(which[k], distances[k]);
      of_a[which[k]].offer(j, distances[k]);
    }
  }
  return mutual(of_a, of_b, bounds);
}

}  // namespace

int hamming(const Descriptor& a, const Descriptor& b) {
  int bits = 0;
  for (std::size_t i = 0; i < a.size(); ++i) bits += std::popcount(a[i] ^ b[i]);
  return bits;
}

void hamming(const Descriptor& from, std::span<const Descriptor> to, std::span<const std::uint32_t> which,
             std::vector<std::uint16_t>& out) {
  out.resize(which.size());
#if defined(__x86_64__)
  if (__builtin_cpu_supports("popcnt")) return distances_popcnt(from, to, which, out.data());
#endif
  std::transform(which.begin(), which.end(), out.begin(),
                 [&](std::uint32_t i) { return static_cast<std::uint16_t>(hamming(from, to[i])); });
}

std::vector<Match> match_descriptors(std::span<const Descriptor> a, std::span<const Descriptor> b,
                                     const MatchBounds& bounds) {
  std::vector<std::uint32_t> all(a.size());
  std::iota(all.begin(), all.end(), 0U);
  return match_among(a, b, bounds, [&](std::uint32_t) { return std::span<const std::uint32_t>(all); });
}

std::vector<Match> match_descriptors(std::span<const Descriptor> a, std::span<const Descriptor> b,
                                     const MatchBounds& bounds,
                                     const std::vector<std::vector<std::uint32_t>>& candidates_of_b) {
  return match_among(a, b, bounds,
                     [&](std::uint32_t j) { return std::span<const std::uint32_t>(candidates_of_b[j]); });
}

}  // namespace weft::agents
