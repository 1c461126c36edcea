// The lamps on a grid over the image, and what the sensor makes of light: vignetting, exposure and noise.
#include <algorithm>
#include <cmath>

#include "agents/bodies/sim/camera.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr std::size_t kNoise = 1U << 18U;

}  // namespace

void Camera::make_noise() {
  Random random(0x6e6f697365ULL);
  noise_.resize(kNoise + static_cast<std::size_t>(camera_.width));
  for (float& value : noise_) {
    value = static_cast<float>(random.normal());
  }
}

/// Darkens the grid by specks on the lens: far out of focus, each dims a blurred disc of the image, always the same.
void Camera::soil_lens() {
  constexpr double kLeastPx = 14.0;  // of its radius: finer than the grid of nodes none is
  constexpr double kMostPx = 55.0;
  Random random(options_.lens_seed ^ 0x6c656e73ULL);
  for (int spot = 0; spot < options_.lens_spots; ++spot) {
    const double u = random.uniform(0.0, camera_.width);
    const double v = random.uniform(0.0, camera_.height);
    const double radius = random.uniform(kLeastPx, kMostPx);
    const double depth = options_.lens_depth * random.uniform(0.4, 1.0);
    for (int j = 0; j < rows_; ++j) {
      for (int i = 0; i < columns_; ++i) {
        const double r = std::hypot(i * kShadeCell - u, j * kShadeCell - v) / radius;
        const double within = std::max(0.0, 1.0 - r * r);
        vignette_[static_cast<std::size_t>(j * columns_ + i)] *= static_cast<float>(1.0 - depth * within * within);
      }
    }
  }
}

void Camera::light_grid(const FloorShot& shot) {
  const Eigen::Vector3d& eye = shot.site_from_camera_mid.translation;
  light_.look_around(eye.x(), eye.y(), shot.time_s);
  light_.on_floor(nodes_.x, nodes_.y, eye, shot.body, options_.shadow, gain_, add_);
  for (std::size_t n = 0; n < gain_.size(); ++n) {
    const float gain = static_cast<float>(shot.gain) * vignette_[n];
    gain_[n] *= gain;
    add_[n] *= gain;
  }
}

namespace {

/// Interpolates in a cell: `s` to the right and `t` down, from `above` and the one after it to those `below`.
float between(const float* above, const float* below, float s, float t) {
  return (1 - t) * ((1 - s) * above[0] + s * above[1]) + t * ((1 - s) * below[0] + s * below[1]);
}

}  // namespace

Camera::PixelLight Camera::light_at(int u, int v, double exposure_gain) const {
  const auto n = static_cast<std::size_t>((v / kShadeCell) * columns_ + u / kShadeCell);
  const auto below = n + static_cast<std::size_t>(columns_);
  const float s = static_cast<float>(u % kShadeCell) / kShadeCell;
  const float t = static_cast<float>(v % kShadeCell) / kShadeCell;
  return {between(&gain_[n], &gain_[below], s, t), between(&add_[n], &add_[below], s, t),
          static_cast<float>(exposure_gain) * between(&vignette_[n], &vignette_[below], s, t)};
}

Camera::CellLight Camera::light_in_cell(int u, int v, double exposure_gain) const {
  const auto n = static_cast<std::size_t>((v / kShadeCell) * columns_ + u / kShadeCell);
  const auto below = n + static_cast<std::size_t>(columns_);
  const float t = static_cast<float>(v % kShadeCell) / kShadeCell;
  CellLight light{};
#pragma GCC unroll 1  // several at a time rather than one after the other
  for (std::size_t i = 0; i < kShadeCell; ++i) {
    const float s = static_cast<float>(i) / kShadeCell;
    light.gain[i] = between(&gain_[n], &gain_[below], s, t);
    light.add[i] = between(&add_[n], &add_[below], s, t);
    light.camera_gain[i] = static_cast<float>(exposure_gain) * between(&vignette_[n], &vignette_[below], s, t);
  }
  return light;
}

Bytes Camera::develop(const FloorShot& shot) const {
  Bytes image;
  image.reserve(rays_.x.size());
  Bytes row(static_cast<std::size_t>(camera_.width));
  Random random(shot.noise_seed);
  for (int v = 0; v < camera_.height; ++v) {
    const auto at = static_cast<std::size_t>(v) * static_cast<std::size_t>(camera_.width);
    const auto node = static_cast<std::ptrdiff_t>(v / kShadeCell) * columns_;
    ShadeJob job;
    job.albedo = albedo_.data() + at;
    job.gain_above = gain_.data() + node;
    job.gain_below = job.gain_above + columns_;
    job.add_above = add_.data() + node;
    job.add_below = job.add_above + columns_;
    job.below = static_cast<float>(v % kShadeCell) / kShadeCell;
    job.noise = noise_.data() + random.below(kNoise);
    job.noise_scale = static_cast<float>(options_.noise_grey);
    job.count = camera_.width;
    job.out = row.data();
    kernels().shade_row(job);
    image.insert(image.end(), row.begin(), row.end());  // cheaper than to clear a whole image first
  }
  return image;
}

}  // namespace weft::agents::sim
