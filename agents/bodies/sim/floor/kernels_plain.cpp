#include <cmath>
#include <cstddef>

#include "agents/bodies/sim/floor/kernels.hpp"

namespace weft::agents::sim {
namespace plain {
namespace {

constexpr int kFaceLanes = 2;
#include "agents/bodies/sim/faces_body.hpp"
#include "agents/bodies/sim/floor/kernels_body.hpp"

float sample(const LevelPixels& level, float x_m, float y_m) {
  const float u = x_m * level.texels_per_m - 0.5F;
  const float v = y_m * level.texels_per_m - 0.5F;
  const float u_floor = std::floor(u);
  const float v_floor = std::floor(v);
  const float fu = u - u_floor;
  const float fv = v - v_floor;
  const int x = (static_cast<int>(u_floor) + level.x0) & level.mask;
  const int y = (static_cast<int>(v_floor) + level.y0) & level.mask;
  const std::uint8_t* four = level.pairs + static_cast<std::ptrdiff_t>(x >> kStripLog2) * level.strip_bytes +
                             static_cast<std::ptrdiff_t>(y) * kStripRowBytes + 2 * (x & (kStripTexels - 1));
  const auto t0 = static_cast<float>(four[0]);
  const auto b0 = static_cast<float>(four[1]);
  const float t = t0 + fu * (static_cast<float>(four[2]) - t0);
  const float b = b0 + fu * (static_cast<float>(four[3]) - b0);
  return t + fv * (b - t);
}

void sample_row(const RowJob& job) {
  for (int i = 0; i < job.count; ++i) {
    const float x = job.ray_x[i];
    const float y = job.ray_y[i];
    float sum = 0.0F;
    for (int k = 0; k < kSubsamples; ++k) {
      const FloorFromRay& h = *job.floor_from_ray[k];
      float w = h.m[6] * x + h.m[7] * y + h.m[8];
      w = w > h.least_w ? w : h.least_w;
      const float inverse = 1.0F / w;
      const float floor_x = (h.m[0] * x + h.m[1] * y + h.m[2]) * inverse;
      const float floor_y = (h.m[3] * x + h.m[4] * y + h.m[5]) * inverse;
      sum += sample(*job.level[k], floor_x, floor_y);
    }
    job.out[i] = sum * (1.0F / kSubsamples);
  }
}

void shade_row(const ShadeJob& job) {
  const float below = job.below;
  const float above = 1.0F - below;
  for (int cell = 0; cell * kShadeCell < job.count; ++cell) {
    const float g0 = above * job.gain_above[cell] + below * job.gain_below[cell];
    const float g1 = above * job.gain_above[cell + 1] + below * job.gain_below[cell + 1];
    const float a0 = above * job.add_above[cell] + below * job.add_below[cell];
    const float a1 = above * job.add_above[cell + 1] + below * job.add_below[cell + 1];
    for (int i = 0; i < kShadeCell; ++i) {
      const float t = static_cast<float>(i) * (1.0F / kShadeCell);
      const int p = cell * kShadeCell + i;
      float v = job.albedo[p] * (g0 + t * (g1 - g0)) + (a0 + t * (a1 - a0)) + job.noise[p] * job.noise_scale + 0.5F;
      v = v < 0.0F ? 0.0F : v;
      v = v > 255.0F ? 255.0F : v;
      job.out[p] = static_cast<std::uint8_t>(static_cast<std::int32_t>(v));
    }
  }
}

}  // namespace

Kernels make_kernels() {
  return {sample_row, shade_row, halve, add_noise_row, double_row, face_row};
}

}  // namespace plain

const Kernels& kernels() {
  static const Kernels chosen = __builtin_cpu_supports("avx2") ? avx2::make_kernels() : plain::make_kernels();
  return chosen;
}

}  // namespace weft::agents::sim
