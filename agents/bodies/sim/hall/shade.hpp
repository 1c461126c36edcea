#pragma once
#include <cstdint>

/// Shades what eight rays see of a face, in two builds: one for any x86-64 and one for AVX2, chosen at run time. Both
/// give the same numbers. Plain types only: a file built for AVX2 must not share inline code with the others.
namespace weft::agents::sim {

inline constexpr int kShaded = 8;

/// Points to a texture of 2^top texels a side and its area-averaged halvings, in sequence; mirrored beyond its rims.
struct TexelLevels {
  const std::uint8_t* texels = nullptr;
  const std::uint32_t* from = nullptr;  ///< where each level begins
  int top = 0;
};

/// Describes a face as shading needs it. Its coordinates u, v are in [0, 1].
struct ShadedFace {
  TexelLevels levels;
  float per_u = 1.0F, per_v = 1.0F, at_u = 0.0F, at_v = 0.0F;  ///< texels
  float per_m = 1.0F;                                          ///< texels
  float grey = 1.0F;                                           ///< of a texel of 1
  float ground = 0.0F;                                         ///< besides: grey whatever the texel
  float normal[3] = {};
  float light[4] = {};  ///< at (0, 0), (1, 0), (0, 1), (1, 1)
};

/// Describes eight rays, all of which meet `face`: arrays of eight.
struct ShadeRays {
  const float *x = nullptr, *y = nullptr, *z = nullptr;  ///< directions
  const float *u = nullptr, *v = nullptr;                ///< of the face, where they meet it
  const float* distance = nullptr;                       ///< in lengths of the direction
  const float* length = nullptr;                         ///< of the direction
  const float* off_axis2 = nullptr;                      ///< of the direction: length^2 - 1
  float pixel = 0.0F;                                    ///< width of what a ray stands for, over the distance
  float headlight = 0.0F;                                ///< on what is 2 m ahead
  const ShadedFace* face = nullptr;
  float* grey = nullptr;         ///< out
  const float* wider = nullptr;  ///< factors on `pixel`; null: 1
};

using ShadeFace = void (*)(const ShadeRays& rays);
/// Returns the fastest that this machine can run.
ShadeFace shade_face();

namespace plain {
void shade_face(const ShadeRays& rays);
}
namespace avx2 {
void shade_face(const ShadeRays& rays);
}

}  // namespace weft::agents::sim
