#include "agents/bodies/sim/hall/quad_scene.hpp"

#include <gtest/gtest.h>

namespace weft::agents::sim {
namespace {

Quad wall_at(float x) {
  Quad quad;
  quad.corner = {x, -1.0F, 0.0F};
  quad.across = {0.0F, 2.0F, 0.0F};
  quad.up = {0.0F, 0.0F, 4.0F};
  return quad;
}

TEST(QuadScene, SaysWhichIsMetFirstAndWhere) {
  const std::vector<Quad> quads = {wall_at(5.0F), wall_at(3.0F)};
  const QuadScene scene(quads);
  RayPacket rays;
  rays.x.fill(1.0F);
  rays.y[1] = 0.1F;   // passes at 0.3 m beside the middle
  rays.z[2] = 0.5F;   // rises by 1.5 m
  rays.x[3] = -1.0F;  // looks away
  scene.cast({0.0F, 0.0F, 1.0F}, rays);
  EXPECT_EQ(rays.quad[0], 1);
  EXPECT_NEAR(rays.distance[0], 3.0F, 1e-5F);
  EXPECT_NEAR(rays.u[0], 0.5F, 1e-5F);
  EXPECT_NEAR(rays.v[0], 0.25F, 1e-5F);
  EXPECT_NEAR(rays.u[1], 0.65F, 1e-5F);
  EXPECT_NEAR(rays.v[2], 0.625F, 1e-5F);
  EXPECT_EQ(rays.quad[3], -1);
}

TEST(QuadScene, NothingIsMetWhereNothingIs) {
  const QuadScene scene(std::vector<Quad>{});
  RayPacket rays;
  rays.x.fill(1.0F);
  scene.cast(Eigen::Vector3f::Zero(), rays);
  for (const std::int32_t quad : rays.quad) EXPECT_EQ(quad, -1);
  EXPECT_FALSE(scene.is_hidden({0, 0, 0}, {1, 0, 0}));
}

TEST(QuadScene, WhatStandsBetweenHides) {
  const QuadScene scene(std::vector<Quad>{wall_at(3.0F)});
  EXPECT_TRUE(scene.is_hidden({0, 0, 1}, {5, 0, 1}));
  EXPECT_FALSE(scene.is_hidden({0, 0, 1}, {2.9F, 0, 1}));
  EXPECT_FALSE(scene.is_hidden({3.0F, 0, 1}, {5, 0, 1})) << "it does not hide itself";
  EXPECT_FALSE(scene.is_hidden({0, 0, 5}, {5, 0, 5}));
}

TEST(AddBox, FacesLookOutwards) {
  std::vector<Quad> quads;
  const BoxSides box{{2.0, 3.0, 1.0}, 0.7, 2.0, 1.0, 0.5};
  add_box(box, {}, quads);
  ASSERT_EQ(quads.size(), 5U);
  const Eigen::Vector3f middle(2.0F, 3.0F, 1.25F);
  for (const Quad& quad : quads) EXPECT_GT(quad.normal().dot(quad.at(0.5F, 0.5F) - middle), 0.2F);
}

}  // namespace
}  // namespace weft::agents::sim
