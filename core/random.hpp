#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace weft {

/// Draws random numbers from a seed (xoshiro256++, Blackman & Vigna 2019): same seed, same numbers, on every machine
/// and standard library. It is a value: copy it to fork a stream, pass it where randomness is needed.
class Random {
 public:
  explicit Random(std::uint64_t seed);
  std::uint64_t next();
  /// Draws uniformly from [0, 1).
  double uniform() { return static_cast<double>(next() >> 11U) * 0x1.0p-53; }
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Draws a whole number from [0, bound), bound > 0.
  std::uint64_t below(std::uint64_t bound) { return next() % bound; }
  bool chance(double probability) { return uniform() < probability; }
  /// Draws from the standard normal distribution (Box-Muller).
  double normal();
  double normal(double mean, double sigma) { return mean + sigma * normal(); }
  /// Returns a generator whose numbers have nothing to do with this one's, for a part that `stream` numbers.
  Random fork(std::uint64_t stream);

 private:
  std::array<std::uint64_t, 4> state_{};
};

}  // namespace weft
