#pragma once
#include <algorithm>

#include "core/random.hpp"
#include "storage/clouds/cloud.hpp"

namespace weft::clouds::sample {

/// Returns `count` points of a room's floor, a wall and its air, with values below `values_below` (0: none).
inline Cloud room(std::uint64_t seed, std::size_t count, std::uint64_t values_below) {
  Random random(seed);
  Cloud cloud;
  for (std::size_t at = 0; at < count; ++at) {
    const double x = random.uniform(-12.0, 30.0);
    const double y = random.uniform(-7.0, 7.0);
    const double noise = random.normal(0.0, 0.004);
    const std::uint64_t where = random.below(8);
    const Eigen::Vector3d point = where < 4   ? Eigen::Vector3d(x, y, noise)
                                  : where < 7 ? Eigen::Vector3d(x, 7.0 + noise, random.uniform(0.0, 3.0))
                                              : Eigen::Vector3d(x, y, random.uniform(0.0, 3.0));
    cloud.points.emplace_back(point.cast<float>());
    if (values_below > 0) cloud.values.push_back(static_cast<std::uint16_t>(random.below(values_below)));
  }
  return cloud;
}

/// Returns the same points in another order.
inline Cloud shuffled(Cloud cloud, std::uint64_t seed) {
  Random random(seed);
  for (std::size_t left = cloud.points.size(); left > 1; --left) {
    const std::size_t other = random.below(left);
    std::swap(cloud.points[left - 1], cloud.points[other]);
    if (!cloud.values.empty()) std::swap(cloud.values[left - 1], cloud.values[other]);
  }
  return cloud;
}

/// Returns the same with `size` bytes attached, which do not shrink: descriptors.
inline Cloud with_attachment(Cloud cloud, std::uint64_t seed, std::size_t size) {
  Random random(seed);
  for (std::size_t at = 0; at < size; ++at) cloud.attached.push_back(static_cast<std::uint8_t>(random.next()));
  return cloud;
}

/// Returns the content of a place: a cloud on a lattice of 5 mm with the numbers of its frames, and features
/// attached.
inline Bytes place_content(std::uint64_t seed, std::size_t points) {
  return canonical_bytes(with_attachment(room(seed, points, 8), seed, points / 4), 5000).value();
}

inline Cloud of_points(std::vector<Eigen::Vector3f> points) {
  return {std::move(points), {}, {}};
}

}  // namespace weft::clouds::sample
