#include "agents/bodies/sim/relief.hpp"

#include <cmath>
#include <numbers>

#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kLeastWaveM = 0.3;
constexpr double kMostWaveM = 3.0;

/// Returns the sine of so many turns, within 1e-7. Without a branch, so that several are worked out together.
double sine_of_turns(double turns) {
  constexpr double kNoFraction = 6755399441055744.0;  // 1.5 * 2^52: beside such a summand a double has no fraction
  const double from_nearest = turns - ((turns + kNoFraction) - kNoFraction);
  // The same sine within a quarter of a turn of 0, where a short series is near enough.
  const double half = from_nearest < 0.0 ? -0.5 : 0.5;
  const double size = from_nearest < 0.0 ? -from_nearest : from_nearest;
  const double folded = size > 0.25 ? half - from_nearest : from_nearest;
  const double x = 2.0 * std::numbers::pi * folded;
  const double x2 = x * x;
  return x * (1.0 + x2 * (-1.0 / 6 + x2 * (1.0 / 120 + x2 * (-1.0 / 5040 + x2 * (1.0 / 362880 - x2 / 39916800)))));
}

}  // namespace

Relief::Relief(double peak_m, std::uint64_t floor_seed) : peak_m_(peak_m) {
  Random random(floor_seed ^ 0x72656c696566ULL);
  double squares = 0.0;
  const double first_direction = random.uniform();
  for (int i = 0; i < kWaves; ++i) {
    const auto at = static_cast<std::size_t>(i);
    // One wave in each part of the range of lengths, and of directions: no seed leaves a part of either empty.
    const double share = (i + random.uniform()) / kWaves;
    const double wave_m = kLeastWaveM * std::pow(kMostWaveM / kLeastWaveM, share);
    const double direction = 2.0 * std::numbers::pi * (first_direction + std::numbers::phi * i);
    per_x_[at] = std::cos(direction) / wave_m;
    per_y_[at] = std::sin(direction) / wave_m;
    begins_[at] = random.uniform();
    height_[at] = wave_m;
    squares += wave_m * wave_m / 2;
  }
  for (double& height : height_) height /= std::sqrt(squares);
}

double Relief::height_m(double x, double y) const {
  PerWave heights;
  for (std::size_t i = 0; i < kWaves; ++i)
    heights[i] = height_[i] * sine_of_turns(per_x_[i] * x + per_y_[i] * y + begins_[i]);
  double sum = 0.0;
  for (const double height : heights) sum += height;
  return peak_m_ * std::tanh(sum);
}

double Relief::steep() const {
  double squares = 0.0;
  for (std::size_t i = 0; i < kWaves; ++i) {
    const double slope = 2.0 * std::numbers::pi * height_[i] * std::hypot(per_x_[i], per_y_[i]);
    squares += slope * slope / 4;  // half of a wave's slope lies along any given direction
  }
  return 3.3 * peak_m_ * std::sqrt(squares);
}

std::optional<Relief> relief_of(const Site& site) {
  if (site.disturbances.unevenness_m <= 0.0) return std::nullopt;
  return Relief(site.disturbances.unevenness_m, site.floor.seed);
}

}  // namespace weft::agents::sim
