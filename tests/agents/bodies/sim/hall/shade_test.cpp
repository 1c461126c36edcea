#include "agents/bodies/sim/hall/shade.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "agents/bodies/sim/hall/textures.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

/// Holds eight rays straight ahead at a face that they meet at (u, v), `distance` away.
struct Rays {
  std::array<float, kShaded> x{}, y{}, z{}, u{}, v{}, distance{}, length{}, off_axis2{}, grey{};

  ShadeRays at(const ShadedFace& face, float headlight = 0.0F) {
    return {x.data(),      y.data(),         z.data(), u.data(),  v.data(), distance.data(),
            length.data(), off_axis2.data(), 0.001F,   headlight, &face,    grey.data()};
  }
};

Rays ahead(float u, float v, float distance) {
  Rays rays;
  rays.x.fill(1.0F);
  rays.u.fill(u);
  rays.v.fill(v);
  rays.distance.fill(distance);
  rays.length.fill(1.0F);
  return rays;
}

ShadedFace face_of(const Texture& texture) {
  ShadedFace face;
  face.levels = texture.levels();
  face.per_u = face.per_v = static_cast<float>(texture.side());
  face.per_m = 10.0F;
  face.normal[0] = 1.0F;
  std::fill(std::begin(face.light), std::end(face.light), 1.0F);
  return face;
}

Texture noise(int side) {
  Random random(5);
  std::vector<std::uint8_t> texels;
  for (int i = 0; i < side * side; ++i) texels.push_back(static_cast<std::uint8_t>(random.below(256)));
  return {side, texels};
}

TEST(ShadeFace, BothBuildsGiveTheSameNumbers) {
  if (!__builtin_cpu_supports("avx2")) GTEST_SKIP() << "this machine can run one of them only";
  Random random(7);
  const Texture texture = noise(64);
  ShadedFace face = face_of(texture);
  for (int round = 0; round < 500; ++round) {
    Rays rays;
    for (std::size_t i = 0; i < kShaded; ++i) {
      rays.x[i] = 1.0F;
      rays.y[i] = static_cast<float>(random.uniform(-0.6, 0.6));
      rays.z[i] = static_cast<float>(random.uniform(-0.4, 0.4));
      rays.off_axis2[i] = rays.y[i] * rays.y[i] + rays.z[i] * rays.z[i];
      rays.length[i] = std::sqrt(1.0F + rays.off_axis2[i]);
      rays.u[i] = static_cast<float>(random.uniform(0.0, 1.0));
      rays.v[i] = static_cast<float>(random.uniform(0.0, 1.0));
      rays.distance[i] = static_cast<float>(random.uniform(0.3, 400.0));
    }
    for (float& light : face.light) light = static_cast<float>(random.uniform(0.0, 3.0));
    face.at_u = static_cast<float>(random.uniform(-500.0, 500.0));
    face.ground = round % 3 == 0 ? 0.0F : static_cast<float>(random.uniform(0.0, 120.0));
    const float headlight = round % 2 == 0 ? 0.0F : 1.5F;
    plain::shade_face(rays.at(face, headlight));
    const std::array<float, kShaded> one = rays.grey;
    rays.grey.fill(-1.0F);
    avx2::shade_face(rays.at(face, headlight));
    EXPECT_EQ(rays.grey, one);
  }
}

TEST(ShadeFace, NearItIsTheTexelFarOffTheMean) {
  const Texture texture = noise(64);
  const TexelLevels levels = texture.levels();
  const ShadedFace face = face_of(texture);
  Rays near = ahead(10.5F / 64.0F, 20.5F / 64.0F, 1.0F);
  plain::shade_face(near.at(face));
  EXPECT_FLOAT_EQ(near.grey[0], levels.texels[20 * 64 + 10]) << "the middle of a texel";
  Rays far = ahead(0.5F, 0.5F, 1e5F);
  plain::shade_face(far.at(face));
  EXPECT_FLOAT_EQ(far.grey[0], levels.texels[levels.from[levels.top]]) << "one texel is all";
}

TEST(ShadeFace, BeyondItsRimATextureIsMirrored) {
  const Texture texture = noise(64);
  ShadedFace face = face_of(texture);
  Rays rays = ahead(10.5F / 64.0F, 20.5F / 64.0F, 1.0F);
  plain::shade_face(rays.at(face));
  const float within = rays.grey[0];
  face.per_u = -64.0F;  // the same texel, seen from the other side of x = 0
  plain::shade_face(rays.at(face));
  EXPECT_FLOAT_EQ(rays.grey[0], within);
}

TEST(ShadeFace, WhatLiesUnderTheTextureIsLitAsItIs) {
  const Texture texture(1, {100});
  ShadedFace face = face_of(texture);
  face.grey = 0.25F;
  face.ground = 60.0F;
  std::fill(std::begin(face.light), std::end(face.light), 2.0F);
  Rays rays = ahead(0.5F, 0.5F, 1.0F);
  plain::shade_face(rays.at(face));
  EXPECT_FLOAT_EQ(rays.grey[0], 2.0F * (60.0F + 25.0F));
}

TEST(ShadeFace, LightLiesBetweenItsCorners) {
  const Texture texture(1, {100});
  ShadedFace face = face_of(texture);
  face.grey = 0.5F;
  face.light[1] = 3.0F;
  face.light[3] = 3.0F;
  Rays rays = ahead(0.25F, 0.7F, 1.0F);
  plain::shade_face(rays.at(face));
  EXPECT_FLOAT_EQ(rays.grey[0], 0.5F * 100.0F * 1.5F);
  rays = ahead(0.25F, 0.7F, 2.0F);
  plain::shade_face(rays.at(face, 0.5F));
  EXPECT_FLOAT_EQ(rays.grey[0], 0.5F * 100.0F * (1.5F + 0.5F)) << "a headlight is 2 m off what it says";
}

}  // namespace
}  // namespace weft::agents::sim
