#include "agents/bodies/sim/hall/sampled_rays.hpp"

#include <cassert>
#include <cmath>

#include "agents/bodies/sim/hall/quad_scene.hpp"
#include "agents/bodies/sim/pixel_rays.hpp"

namespace weft::agents::sim {
namespace {

constexpr int kBlock = kHallBand;  // pixels a side that one packet looks through
static_assert(kBlock * kBlock == kRays);
// Places within the pixel, each at its own moment: orthogonal to time and to each other.
constexpr std::array<float, kHallSamples> kRight = {0.25F, -0.25F, -0.25F, 0.25F};
constexpr std::array<float, kHallSamples> kDown = {-0.125F, 0.375F, -0.375F, 0.125F};

/// Holds how a ray moves when the pixel does, by one pixel to the right and by one down.
struct Moves {
  float right_x = 0.0F, right_y = 0.0F, down_x = 0.0F, down_y = 0.0F;
};

/// Measures how rays move across a fisheye's image, between the neighbours of a pixel.
Moves moves_at(const PixelRays& rays, const CameraModel& camera, std::size_t pixel) {
  const auto width = static_cast<std::size_t>(camera.width);
  const auto height = static_cast<std::size_t>(camera.height);
  const std::size_t row = pixel / width;
  const std::size_t column = pixel - row * width;
  const std::size_t left = pixel - (column > 0 ? 1 : 0);
  const std::size_t right = pixel + (column + 1 < width ? 1 : 0);
  const std::size_t above = pixel - (row > 0 ? width : 0);
  const std::size_t below = pixel + (row + 1 < height ? width : 0);
  const auto across = static_cast<float>(right - left);
  const float down = static_cast<float>(below - above) / static_cast<float>(width);
  return {(rays.x[right] - rays.x[left]) / across, (rays.y[right] - rays.y[left]) / across,
          (rays.x[below] - rays.x[above]) / down, (rays.y[below] - rays.y[above]) / down};
}

/// Returns the share of light that arrives at a pixel.
float vignette_at(const CameraModel& camera, std::size_t pixel, double vignetting) {
  const auto width = static_cast<std::size_t>(camera.width);
  const std::size_t row = pixel / width;
  const double corner = std::hypot(camera.width / 2.0, camera.height / 2.0);
  const double r =
      std::hypot(static_cast<double>(pixel - row * width) - camera.cx, static_cast<double>(row) - camera.cy) / corner;
  return static_cast<float>(1.0 - vignetting * r * r);
}

}  // namespace

std::size_t BlockPixels::at(std::size_t block, std::size_t i) const {
  const auto across = static_cast<std::size_t>(columns / kBlock);
  const std::size_t row = block / across * kBlock + i / kBlock;
  return row * static_cast<std::size_t>(columns) + block % across * kBlock + i % kBlock;
}

SampledRays::SampledRays(const CameraModel& camera, double vignetting, double widest_rad) {
  assert(camera.width % kBlock == 0 && camera.height % kBlock == 0);
  const PixelRays rays(camera);
  const BlockPixels pixels{camera.width};
  const auto widest = static_cast<float>(widest_rad);
  for (std::size_t at = 0; at < rays.x.size(); ++at) {
    const std::size_t pixel = pixels.at(at / kRays, at % kRays);
    const float ray_x = rays.x[pixel];
    const float ray_y = rays.y[pixel];
    add_looks(rays, camera, pixel);
    off_axis2.push_back(ray_x * ray_x + ray_y * ray_y);
    length.push_back(std::sqrt(1.0F + off_axis2.back()));
    const bool is_dark = widest > 0.0F && std::atan(std::sqrt(off_axis2.back())) > widest;
    vignette.push_back(is_dark ? 0.0F : vignette_at(camera, pixel, vignetting));
  }
}

void SampledRays::add_looks(const PixelRays& rays, const CameraModel& camera, std::size_t pixel) {
  if (camera.lens == LensModel::equidistant) {
    const Moves moves = moves_at(rays, camera, pixel);
    for (std::size_t k = 0; k < kHallSamples; ++k) {
      x[k].push_back(rays.x[pixel] + kRight[k] * moves.right_x + kDown[k] * moves.down_x);
      y[k].push_back(rays.y[pixel] + kRight[k] * moves.right_y + kDown[k] * moves.down_y);
    }
    return;
  }
  for (std::size_t k = 0; k < kHallSamples; ++k) {
    x[k].push_back(rays.x[pixel] + kRight[k] / static_cast<float>(camera.fx));
    y[k].push_back(rays.y[pixel] + kDown[k] / static_cast<float>(camera.fy));
  }
}

}  // namespace weft::agents::sim
