#include "agents/perception/hamming.hpp"

#include <algorithm>
#include <bit>
#include <limits>

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
__attribute__((target("popcnt"))) void distances_popcnt(const Descriptor& from, const std::vector<Descriptor>& to,
                                                        std::vector<std::uint16_t>& out) {
  for (std::size_t i = 0; i < to.size(); ++i)
    out[i] = static_cast<std::uint16_t>(
        __builtin_popcountll(from[0] ^ to[i][0]) + __builtin_popcountll(from[1] ^ to[i][1]) +
        __builtin_popcountll(from[2] ^ to[i][2]) + __builtin_popcountll(from[3] ^ to[i][3]));
}
#endif

void distances_portable(const Descriptor& from, const std::vector<Descriptor>& to, std::vector<std::uint16_t>& out) {
  for (std::size_t i = 0; i < to.size(); ++i) out[i] = static_cast<std::uint16_t>(hamming(from, to[i]));
}

void distances(const Descriptor& from, const std::vector<Descriptor>& to, std::vector<std::uint16_t>& out) {
  out.resize(to.size());
#if defined(__x86_64__)
  if (__builtin_cpu_supports("popcnt")) return distances_popcnt(from, to, out);
#endif
  distances_portable(from, to, out);
}

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

}  // namespace

int hamming(const Descriptor& a, const Descriptor& b) {
  int bits = 0;
  for (std::size_t i = 0; i < a.size(); ++i) bits += std::popcount(a[i] ^ b[i]);
  return bits;
}

std::vector<Match> match_descriptors(const std::vector<Descriptor>& a, const std::vector<Descriptor>& b,
                                     const MatchBounds& bounds) {
  std::vector<Nearest> of_a(a.size());
  std::vector<Nearest> of_b(b.size());
  std::vector<std::uint16_t> row;
  for (std::uint32_t j = 0; j < b.size(); ++j) {
    distances(b[j], a, row);
    for (std::uint32_t i = 0; i < a.size(); ++i) {
      of_b[j].offer(i, row[i]);
      of_a[i].offer(j, row[i]);
    }
  }
  return mutual(of_a, of_b, bounds);
}

std::vector<Match> match_descriptors(const std::vector<Descriptor>& a, const std::vector<Descriptor>& b,
                                     const MatchBounds& bounds,
                                     const std::vector<std::vector<std::uint32_t>>& candidates_of_b) {
  std::vector<Nearest> of_a(a.size());
  std::vector<Nearest> of_b(b.size());
  for (std::uint32_t j = 0; j < b.size(); ++j)
    for (const std::uint32_t i : candidates_of_b[j]) {
      const int distance = hamming(a[i], b[j]);
      of_b[j].offer(i, distance);
      of_a[i].offer(j, distance);
    }
  return mutual(of_a, of_b, bounds);
}

}  // namespace weft::agents
