#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "agents/bodies/sim/camera.hpp"
#include "agents/perception/lens.hpp"
#include "sites.hpp"

namespace weft::agents::sim {

inline Eigen::Vector2d pixel_of(const CameraModel& model, const Pose3& site_from_camera,
                                const Eigen::Vector3d& in_site) {
  const Eigen::Vector3d p = site_from_camera.inverse() * in_site;
  return pixel_from_normalised(model, {p.x() / p.z(), p.y() / p.z()});
}

inline Eigen::Vector2d centroid_of(const std::vector<Eigen::Vector2d>& polygon) {
  double area = 0.0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d a = polygon[i] - polygon[0];
    const Eigen::Vector2d b = polygon[(i + 1) % polygon.size()] - polygon[0];
    const double cross = a.x() * b.y() - a.y() * b.x();
    area += cross;
    sum += cross * (a + b) / 3.0;
  }
  return polygon[0] + sum / area;
}

/// Describes one mark of a DottedFloor in an image: where it is on the floor, and how far from there it is seen.
struct MarkSeen {
  Eigen::Vector2d on_floor, off_px;
};

/// Returns all marks that are whole in the image and have room around them. `project` takes points of the floor's
/// plan to pixels.
inline std::vector<MarkSeen> marks_seen(const CameraModel& model, const Pose3& site_from_camera, const Bytes& image,
                                        const std::function<Eigen::Vector2d(const Eigen::Vector2d&)>& project) {
  const auto at = [&](int u, int v) { return image[static_cast<std::size_t>(v * model.width + u)]; };
  std::vector<MarkSeen> marks;
  for (int i = 5; i < 40; ++i) {
    for (int j = 0; j < 40; ++j) {
      const Eigen::Vector2d mark(i * DottedFloor::kSpacingM, j * DottedFloor::kSpacingM);
      const Eigen::Vector3d in_camera = site_from_camera.inverse() * Eigen::Vector3d(mark.x(), mark.y(), 0.0);
      if (in_camera.z() < 0.3 || in_camera.z() > 1.5) continue;
      std::vector<Eigen::Vector2d> around;
      for (int k = 0; k < 90; ++k) {
        const double angle = 2.0 * M_PI * k / 90;
        around.push_back(project(mark + DottedFloor::kRadiusM * Eigen::Vector2d(std::cos(angle), std::sin(angle))));
      }
      Eigen::Vector2d low = around[0];
      Eigen::Vector2d high = around[0];
      for (const Eigen::Vector2d& p : around) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
      }
      constexpr double kRim = 5.0;
      if (low.minCoeff() < kRim + 1 || high.x() > model.width - kRim - 2 || high.y() > model.height - kRim - 2)
        continue;
      double weights = 0.0;
      double rim = 0.0;
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      const Eigen::Vector2i first = (low.array() - kRim).cast<int>().matrix();
      const Eigen::Vector2i last = (high.array() + kRim).cast<int>().matrix();
      const double white = at(first.x(), first.y());
      for (int v = first.y(); v <= last.y(); ++v) {
        for (int u = first.x(); u <= last.x(); ++u) {
          const double dark = white - at(u, v);
          weights += dark;
          sum += dark * Eigen::Vector2d(u, v);
          if (u == first.x() || u == last.x() || v == first.y() || v == last.y()) rim = std::max(rim, std::abs(dark));
        }
      }
      if (rim > 20.0) continue;  // its neighbour looks in
      marks.push_back({mark, sum / weights - centroid_of(around)});
    }
  }
  return marks;
}

inline void expect_where_they_belong(const std::vector<MarkSeen>& marks) {
  double squares = 0.0;
  for (const MarkSeen& mark : marks) {
    EXPECT_LT(mark.off_px.norm(), 0.12) << "mark at " << mark.on_floor.transpose() << " is off by "
                                        << mark.off_px.transpose();
    squares += mark.off_px.squaredNorm();
  }
  EXPECT_GT(marks.size(), 25U);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(marks.size())), 0.05);
}

}  // namespace weft::agents::sim
