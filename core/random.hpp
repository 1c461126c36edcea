#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace weft {

/// Seeded generator (xoshiro256++, Blackman & Vigna 2019): same seed, same numbers, on every machine and
/// standard library. A value: copy it to fork a stream, pass it where randomness is needed.
class Random {
 public:
  explicit Random(std::uint64_t seed);
  std::uint64_t next();
  /// [0, 1)
  double uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// [0, bound), bound > 0
  std::uint64_t below(std::uint64_t bound) { return next() % bound; }
  bool chance(double probability) { return uniform() < probability; }
  /// Standard normal, Box-Muller.
  double normal();
  double normal(double mean, double sigma) { return mean + sigma * normal(); }
  /// A generator whose numbers have nothing to do with this one's, for a named part.
  Random fork(std::uint64_t stream);

 private:
  std::array<std::uint64_t, 4> state_{};
};

}  // namespace weft
