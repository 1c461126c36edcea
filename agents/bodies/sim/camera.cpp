#include "agents/bodies/sim/camera.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace weft::agents::sim {
namespace {

constexpr double kFarthestM = 6.0;  // the floor is drawn no further; the horizon is out of view
constexpr double kMarginM = 0.1;    // of what is fetched around each grid node
constexpr int kBlock = 128;         // pixels a side that are sampled together: their texels share cache lines

TileKey tile_of(double x, double y) {
  return {static_cast<std::int32_t>(std::floor(x / kTileM)), static_cast<std::int32_t>(std::floor(y / kTileM))};
}

}  // namespace

Camera::Camera(const CameraModel& camera, const CameraOptions& options, std::shared_ptr<const FloorSource> floor,
               std::shared_ptr<const Scene> scene, const Light& light)
    : camera_(camera),
      options_(options),
      columns_(camera.width / kShadeCell + 1),
      rows_(camera.height / kShadeCell + 2),
      rays_(camera),
      levels_(levels_of_rows()),
      floor_(std::move(floor), reach_m(), options.cache_bytes),
      scene_(std::move(scene)),
      light_(light),
      bent_(kShadeCell, columns_, rows_) {
  assert(camera_.width % kShadeCell == 0);
  make_noise();
  const auto nodes = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  nodes_.x.resize(nodes);
  nodes_.y.resize(nodes);
  gain_.resize(nodes);
  add_.resize(nodes);
  albedo_.resize(rays_.x.size());
  hits_.resize(rays_.x.size());
  const double corner = std::hypot(camera_.width / 2.0, camera_.height / 2.0);
  for (int j = 0; j < rows_; ++j) {
    for (int i = 0; i < columns_; ++i) {
      const double r = std::hypot(i * kShadeCell - camera_.cx, j * kShadeCell - camera_.cy) / corner;
      vignette_.push_back(static_cast<float>(1.0 - options_.vignetting * r * r));
    }
  }
  soil_lens();
}

FloorFromRay Camera::floor_from_ray(const Pose3& site_from_camera, double origin_x, double origin_y, double right_px,
                                    double down_px) const {
  const Eigen::Matrix3d r = site_from_camera.rotation.toRotationMatrix();
  const Eigen::Vector3d& c = site_from_camera.translation;
  // Camera centre + t * ray on z = 0: t = c.z / w with w = -(third row) . ray.
  Eigen::Matrix3d m;
  m.row(2) = -r.row(2);
  m.row(0) = c.z() * r.row(0) + (c.x() - origin_x) * m.row(2);
  m.row(1) = c.z() * r.row(1) + (c.y() - origin_y) * m.row(2);
  m.col(2) += m.col(0) * (right_px / camera_.fx) + m.col(1) * (down_px / camera_.fy);
  FloorFromRay h;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      h.m[3 * i + j] = static_cast<float>(m(i, j));
    }
  }
  h.least_w = static_cast<float>(c.z() / kFarthestM);
  return h;
}

namespace {

Eigen::Vector2d floor_point(const FloorFromRay& h, float x, float y) {
  const double w = std::max(h.least_w, h.m[6] * x + h.m[7] * y + h.m[8]);
  return {(h.m[0] * x + h.m[1] * y + h.m[2]) / w, (h.m[3] * x + h.m[4] * y + h.m[5]) / w};
}

}  // namespace

std::array<double, kLevels> Camera::reach_m() const {
  Pose3 robot_from_camera = camera_.robot_from_camera;
  if (options_.relief) {  // on a slope it looks farther
    const Eigen::AngleAxisd up(-std::atan(options_.relief->steep()), Eigen::Vector3d::UnitY());
    robot_from_camera.rotation = up * robot_from_camera.rotation;
  }
  const FloorFromRay h = floor_from_ray(robot_from_camera, 0.0, 0.0, 0.0, 0.0);
  std::array<std::vector<Eigen::Vector2d>, kLevels> seen;
  for (int v = 0; v < camera_.height; ++v) {
    // As fetch_floor does: a level is wanted a little beyond the rows that sample it.
    std::array<bool, kLevels> wanted{};
    for (int near = v - 2 * kShadeCell; near <= v + 2 * kShadeCell; near += kShadeCell / 2) {
      for (const std::size_t level : levels_[static_cast<std::size_t>(std::clamp(near, 0, camera_.height - 1))]) {
        wanted[level] = true;
      }
    }
    for (const int u : {0, camera_.width / 2, camera_.width - 1}) {
      const Eigen::Vector2d p = floor_point(h, rays_.x[pixel(u, v)], rays_.y[pixel(u, v)]);
      for (std::size_t level = 0; level < kLevels; ++level) {
        if (wanted[level] && (v % 8 == 0 || v == camera_.height - 1)) {
          seen[level].push_back(p);
        }
      }
    }
  }
  std::array<double, kLevels> reach{};
  for (std::size_t level = 0; level < kLevels; ++level) {
    for (const Eigen::Vector2d& a : seen[level]) {
      for (const Eigen::Vector2d& b : seen[level]) {
        reach[level] = std::max(reach[level], (a - b).norm() + 2 * kMarginM + 0.2);
      }
    }
  }
  return reach;
}

std::vector<Camera::RowLevels> Camera::levels_of_rows() const {
  std::vector<RowLevels> levels;
  const FloorFromRay h = floor_from_ray(camera_.robot_from_camera, 0.0, 0.0, 0.0, 0.0);
  const int u = camera_.width / 2;
  for (int v = 0; v < camera_.height; ++v) {
    const int row = std::min(v, camera_.height - 2);
    const auto at =
        static_cast<std::size_t>(row) * static_cast<std::size_t>(camera_.width) + static_cast<std::size_t>(u);
    const Eigen::Vector2d here = floor_point(h, rays_.x[at], rays_.y[at]);
    const Eigen::Vector2d right = floor_point(h, rays_.x[at + 1], rays_.y[at + 1]);
    const std::size_t under = at + static_cast<std::size_t>(camera_.width);
    const Eigen::Vector2d below = floor_point(h, rays_.x[under], rays_.y[under]);
    // Across, one sample covers the pixel; along, four share it.
    const double across = (right - here).norm();
    const double along = (below - here).norm();
    const double level = std::log2(std::max(across, along / kSubsamples) / kTexelM);
    RowLevels row_levels{};
    for (int k = 0; k < kSubsamples; ++k) {
      // Each subsample changes level at another row: between levels the mean fades from one to the next.
      const double own = std::floor(level + (k + 0.5) / kSubsamples);
      row_levels[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(std::clamp(own, 0.0, kLevels - 1.0));
    }
    levels.push_back(row_levels);
  }
  return levels;
}

void Camera::look_at_grid(const FloorShot& shot) {
  for (int j = 0; j < rows_; ++j) {
    const int v = row_of_node(j);
    const Pose3& site_from_camera = shot.mid_of_row(v);
    const Eigen::Vector3d& viewpoint = site_from_camera.translation;
    const FloorFromRay h = floor_from_ray(site_from_camera, viewpoint.x(), viewpoint.y(), 0.0, 0.0);
    for (int i = 0; i < columns_; ++i) {
      const int u = std::min(i * kShadeCell, camera_.width - 1);
      const auto at =
          static_cast<std::size_t>(v) * static_cast<std::size_t>(camera_.width) + static_cast<std::size_t>(u);
      Eigen::Vector2d p = floor_point(h, rays_.x[at], rays_.y[at]) + viewpoint.head<2>();
      const auto n = static_cast<std::size_t>(j * columns_ + i);
      if (options_.relief) {
        const FloorMet met = meet_floor(*options_.relief, site_from_camera, p);
        bent_.set(n, met);
        p = met.at;
      }
      nodes_.x[n] = static_cast<float>(p.x());
      nodes_.y[n] = static_cast<float>(p.y());
    }
  }
}

void Camera::fetch_floor() {
  for (int j = 0; j < rows_; ++j) {
    int least = kLevels;
    int most = 0;
    for (int v = (j - 1) * kShadeCell; v <= (j + 1) * kShadeCell; ++v) {
      for (const int level : levels_[static_cast<std::size_t>(std::clamp(v, 0, camera_.height - 1))]) {
        least = std::min(least, level);
        most = std::max(most, level);
      }
    }
    TileKey last_low{INT32_MIN, 0};
    TileKey last_high{};
    for (int i = 0; i < columns_; ++i) {
      const auto n = static_cast<std::size_t>(j * columns_ + i);
      const TileKey low = tile_of(nodes_.x[n] - kMarginM, nodes_.y[n] - kMarginM);
      const TileKey high = tile_of(nodes_.x[n] + kMarginM, nodes_.y[n] + kMarginM);
      if (low == last_low && high == last_high) {
        continue;
      }
      last_low = low;
      last_high = high;
      for (TileKey key = low; key.y <= high.y; ++key.y) {
        for (key.x = low.x; key.x <= high.x; ++key.x) {
          for (int level = least; level <= most; ++level) {
            floor_.need(level, key);
          }
        }
      }
    }
  }
}

/// Returns one for each image row; one alone when all are taken at once.
std::vector<Camera::FloorFromSubsamples> Camera::floor_from_rows(const FloorShot& shot, TileKey origin) const {
  std::vector<FloorFromSubsamples> all(shot.rows.empty() ? 1 : shot.rows.size());
  for (std::size_t row = 0; row < all.size(); ++row) {
    const std::array<Pose3, kSubsamples>& poses = shot.poses_of_row(static_cast<int>(row));
    for (std::size_t k = 0; k < kSubsamples; ++k) {
      all[row][k] =
          floor_from_ray(poses[k], origin.x * kTileM, origin.y * kTileM, kSubsampleRight[k], kSubsampleDown[k]);
    }
  }
  return all;
}

void Camera::sample_floor(const FloorShot& shot) {
  const Eigen::Vector3d& viewpoint = shot.site_from_camera_mid.translation;
  const TileKey origin = tile_of(viewpoint.x(), viewpoint.y());
  const std::vector<FloorFromSubsamples> floor_from_row = floor_from_rows(shot, origin);
  std::array<LevelPixels, kLevels> pixels{};
  for (int l = 0; l < kLevels; ++l) {
    pixels[static_cast<std::size_t>(l)] = floor_.level(l, origin);
  }
  for (int v0 = 0; v0 < camera_.height; v0 += kBlock) {
    for (int u0 = 0; u0 < camera_.width; u0 += kBlock) {
      for (int v = v0; v < std::min(v0 + kBlock, camera_.height); ++v) {
        const FloorFromSubsamples& floor_from_ray_of =
            floor_from_row[shot.rows.empty() ? 0 : static_cast<std::size_t>(v)];
        RowJob job;
        for (std::size_t k = 0; k < kSubsamples; ++k) {
          job.floor_from_ray[k] = &floor_from_ray_of[k];
          job.level[k] = &pixels[levels_[static_cast<std::size_t>(v)][k]];
        }
        sample_row(job, u0, std::min(u0 + kBlock, camera_.width), v);
      }
    }
  }
}

/// Samples the floor in a row's pixels from `begin` to before `end`, where they may show floor.
void Camera::sample_row(RowJob& job, int begin, int end, int v) {
  const auto sees_floor = [this, v](int u) { return shows_.empty() || shows(u, v) != Shows::inside; };
  for (int u = begin; u < end;) {
    const int from = u;
    while (u < end && sees_floor(u)) u += kShadeCell;
    if (u > from) {
      job.ray_x = rays_.x.data() + pixel(from, v);
      job.ray_y = rays_.y.data() + pixel(from, v);
      job.count = u - from;
      if (options_.relief) {
        const auto count = static_cast<std::size_t>(job.count);
        bent_.bend(from, v, {job.ray_x, count}, {job.ray_y, count});
        job.ray_x = bent_.x();
        job.ray_y = bent_.y();
      }
      job.out = albedo_.data() + pixel(from, v);
      kernels().sample_row(job);
    } else {
      u += kShadeCell;
    }
  }
}

Bytes Camera::render(const FloorShot& shot) {
  look_at_grid(shot);
  fetch_floor();
  find_boxes(shot);
  sample_floor(shot);
  light_grid(shot);
  draw_boxes(shot);
  return develop(shot);
}

}  // namespace weft::agents::sim
