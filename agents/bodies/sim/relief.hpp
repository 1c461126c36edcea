#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// Computes a floor's height above its plane: smooth bumps with wavelengths of 0.3 to 3 m, a function of place and
/// seed. Long waves are higher in proportion, so that waves of all lengths are equally steep.
class Relief {
 public:
  /// Draws waves whose heights stay within `peak_m` of the plane; their root mean square is 0.63 of it.
  Relief(double peak_m, std::uint64_t floor_seed);

  double height_m(double x, double y) const;
  /// Returns a slope that fewer than one place in a thousand exceed in a given direction.
  double steep() const;

 private:
  static constexpr int kWaves = 24;
  using PerWave = std::array<double, kWaves>;

  double peak_m_ = 0.0;
  // Turns of each wave a metre along x and y, turns at the origin, and height over the peak.
  PerWave per_x_{}, per_y_{}, begins_{}, height_{};
};

/// Returns the relief of the site's floor; none: it is a plane.
std::optional<Relief> relief_of(const Site& site);

}  // namespace weft::agents::sim
