#pragma once
#include <cstdint>

#include "agents/bodies/sim/faces.hpp"

/// Holds the loops that touch every pixel or texel, in two builds: for any x86-64 and for AVX2, chosen at run time.
/// Both give the same numbers. Plain types only: a file built for AVX2 must not share inline code with the others.
namespace weft::agents::sim {

/// Count the texels across a strip of a level, and the bytes of its row: each texel stands beside the one below it,
/// and the first of the strip to the right is repeated, so that four consecutive bytes are what a bilinear sample
/// needs.
inline constexpr int kStripLog2 = 5;
inline constexpr int kStripTexels = 1 << kStripLog2;
inline constexpr int kStripRowBytes = 2 * (kStripTexels + 1);

/// Points to one level of the floor around the robot; addresses wrap at mask + 1. Rows of a strip follow each other
/// closely: whole rows would lie a multiple of a page apart, and a walk down a column would miss every cache there
/// is.
struct LevelPixels {
  const std::uint8_t* pairs = nullptr;
  int strip_bytes = 0;  ///< of one strip, all its rows
  int mask = 0;
  int x0 = 0, y0 = 0;  ///< texel of the sampling origin
  float texels_per_m = 0.0F;
};

/// Maps a normalised ray (x, y, 1) to floor coordinates (metres from the sampling origin): row-major 3x3, and the
/// least denominator, which keeps rays near the horizon finite.
struct FloorFromRay {
  float m[9] = {};
  float least_w = 1e-3F;
};

inline constexpr int kSubsamples = 4;

/// Describes a run of pixels of a row: means of kSubsamples bilinear samples each, spread over exposure and pixel.
struct RowJob {
  const float* ray_x = nullptr;
  const float* ray_y = nullptr;
  int count = 0;  ///< a multiple of 8
  const FloorFromRay* floor_from_ray[kSubsamples] = {};
  const LevelPixels* level[kSubsamples] = {};
  float* out = nullptr;
};

/// Describes the light and camera gain of a run of pixels, bilinear between grid nodes `cell` pixels apart: out =
/// (albedo * gain + add) + noise * noise_scale, rounded and cut to 0..255.
struct ShadeJob {
  const float* albedo = nullptr;
  const float* gain_above = nullptr;  ///< nodes of the grid row above, and below
  const float* gain_below = nullptr;
  const float* add_above = nullptr;
  const float* add_below = nullptr;
  float below = 0.0F;  ///< share of the row below
  const float* noise = nullptr;
  float noise_scale = 0.0F;
  int count = 0;
  std::uint8_t* out = nullptr;
};
inline constexpr int kShadeCell = 8;

struct Kernels {
  void (*sample_row)(const RowJob& job);
  void (*shade_row)(const ShadeJob& job);
  /// Averages 2 x 2 texels; `side` is that of the result.
  void (*halve)(const std::uint8_t* from, int side, std::uint8_t* to);
  /// Adds amplitude * noise to to[i]; noise of variance 1 (sum of four bytes), a pure function of (x0 + i, y, seed).
  void (*add_noise_row)(std::int32_t x0, std::int32_t y, std::uint32_t seed, int count, float amplitude, float* to);
  /// Doubles a row of a lattice: even and odd children weigh their parents 3 : 1. `from` has count / 2 + 2 values,
  /// the first is the parent before.
  void (*double_row)(const float* from_near, const float* from_far, int count, float* to);
  void (*face_row)(const FaceJob& job);
};
const Kernels& kernels();

namespace plain {
Kernels make_kernels();
}
namespace avx2 {
Kernels make_kernels();
}

}  // namespace weft::agents::sim
