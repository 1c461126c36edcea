#pragma once
#include <vector>

#include "agents/perception/clouds/ndt.hpp"
#include "core/random.hpp"

namespace weft::agents::test {

/// Returns points of the floor, and of walls where they are asked for, with 5 mm of noise; in the frame of the room.
inline std::vector<Eigen::Vector3f> scanned(std::uint64_t seed, bool has_end_wall) {
  Random random(seed);
  std::vector<Eigen::Vector3f> points;
  const auto noisy = [&](double x, double y, double z) {
    points.emplace_back(
        Eigen::Vector3d(x + random.normal(0.0, 0.005), y + random.normal(0.0, 0.005), z + random.normal(0.0, 0.005))
            .cast<float>());
  };
  for (int at = 0; at < 4000; ++at) {
    noisy(random.uniform(-2.0, 3.0), random.uniform(-1.5, 1.5), 0.0);
    noisy(random.uniform(-2.0, 3.0), random.chance(0.5) ? 1.5 : -1.5, random.uniform(0.0, 2.0));
    if (has_end_wall) noisy(3.0, random.uniform(-1.5, 1.5), random.uniform(0.0, 2.0));
  }
  return points;
}

inline Matrix6d covariance_of_sigmas(double metres, double radians) {
  Vector6d sigmas;
  sigmas << metres, metres, metres, radians, radians, radians;
  return sigmas.cwiseAbs2().asDiagonal();
}

}  // namespace weft::agents::test
