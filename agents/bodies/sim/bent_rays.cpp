#include "agents/bodies/sim/bent_rays.hpp"

#include <cmath>

namespace weft::agents::sim {

FloorMet meet_floor(const Relief& relief, const Pose3& site_from_camera, const Eigen::Vector2d& on_plane) {
  constexpr int kMostSteps = 6;  // each is as much nearer as the floor is flatter than the line of sight
  constexpr double kNearEnoughM = 1e-6;
  const Eigen::Vector3d& eye = site_from_camera.translation;
  const Eigen::Vector2d towards_eye = (eye.head<2>() - on_plane) / eye.z();
  Eigen::Vector2d at = on_plane;
  double height_m = 0.0;
  for (int i = 0; i < kMostSteps; ++i) {
    const double here_m = relief.height_m(at.x(), at.y());
    at = on_plane + here_m * towards_eye;
    if (std::abs(here_m - height_m) < kNearEnoughM) break;
    height_m = here_m;
  }
  const auto ray_to = [&](const Eigen::Vector2d& p) -> Eigen::Vector2d {
    const Eigen::Vector3d in_camera =
        site_from_camera.rotation.conjugate() * (Eigen::Vector3d(p.x(), p.y(), 0.0) - eye);
    return in_camera.head<2>() / in_camera.z();
  };
  const Eigen::Vector2d bend = ray_to(at) - ray_to(on_plane);
  return {at, static_cast<float>(bend.x()), static_cast<float>(bend.y())};
}

BentRays::BentRays(int cell, int columns, int rows) : cell_(cell), columns_(columns) {
  bend_x_.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  bend_y_.resize(bend_x_.size());
}

void BentRays::set(std::size_t node, const FloorMet& met) {
  bend_x_[node] = met.bend_x;
  bend_y_[node] = met.bend_y;
}

void BentRays::bend(int u, int v, std::span<const float> ray_x, std::span<const float> ray_y) {
  x_.resize(ray_x.size());
  y_.resize(ray_y.size());
  const float per_cell = 1.0F / static_cast<float>(cell_);
  const float below = static_cast<float>(v % cell_) * per_cell;
  const auto bend_along = [&](const std::vector<float>& bends, std::span<const float> rays,
                              std::vector<float>& bent) {
    const auto cell = static_cast<std::size_t>(cell_);
    auto node = static_cast<std::size_t>(v / cell_ * columns_ + u / cell_);
    for (std::size_t from = 0; from < rays.size(); from += cell, ++node) {
      const std::size_t under = node + static_cast<std::size_t>(columns_);
      const float left = bends[node] + below * (bends[under] - bends[node]);
      const float right = bends[node + 1] + below * (bends[under + 1] - bends[node + 1]);
      const float step = (right - left) * per_cell;
      for (std::size_t i = 0; i < cell; ++i) bent[from + i] = rays[from + i] + (left + step * static_cast<float>(i));
    }
  };
  bend_along(bend_x_, ray_x, x_);
  bend_along(bend_y_, ray_y, y_);
}

}  // namespace weft::agents::sim
