#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "core/geometry/pose3.hpp"

namespace weft::agents {

/// Returns points that are given in frame b, in frame a.
inline std::vector<Eigen::Vector3f> moved(std::span<const Eigen::Vector3f> points_in_b, const Pose3& a_from_b) {
  const Eigen::Matrix3f rotation = a_from_b.rotation.toRotationMatrix().cast<float>();
  const Eigen::Vector3f translation = a_from_b.translation.cast<float>();
  std::vector<Eigen::Vector3f> points_in_a;
  points_in_a.reserve(points_in_b.size());
  for (const Eigen::Vector3f& point : points_in_b) points_in_a.emplace_back(rotation * point + translation);
  return points_in_a;
}

}  // namespace weft::agents
