#include "agents/bodies/sim/hall/textures.hpp"

#include <gtest/gtest.h>

#include "agents/bodies/sim/floor/procedural.hpp"

namespace weft::agents::sim {
namespace {

Textures drawn_textures() {
  return Textures(**make_procedural_floor(FloorSetup{}), 1, {});
}

TEST(Textures, ContrastLeavesTheMeanAsItIs) {
  const Textures textures = drawn_textures();
  Quad wall;
  wall.grey = 100.0F;
  const ShadedFace rich = textures.of(wall);
  EXPECT_EQ(rich.ground, 0.0F);
  EXPECT_EQ(rich.grey, 100.0F / 128.0F);
  for (const float contrast : {0.0F, 0.02F, 0.25F, 1.0F}) {
    wall.contrast = contrast;
    const ShadedFace face = textures.of(wall);
    EXPECT_NEAR(face.ground + 128.0F * face.grey, 100.0F, 1e-3F) << "a mean texel, at contrast " << contrast;
    EXPECT_NEAR(face.grey, contrast * rich.grey, 1e-6F);
  }
}

}  // namespace
}  // namespace weft::agents::sim
