#include "agents/bodies/sim/light.hpp"

#include <gtest/gtest.h>

#include "sites.hpp"

namespace weft::agents::sim {
namespace {

struct Lit {
  float gain = 0.0F, shine = 0.0F;
};

/// Lights a floor point, seen from 0.6 m over (0, 0), under one lamp at (6, 0), 6 m up.
class LightOn : public testing::Test {
 protected:
  LightOn() {
    site_ = empty_site();
    site_.lamps = {{6.0, 0.0, 6.0, 1.0}};
    site_.disturbances = no_disturbances();
  }
  Lit at(float x, float y, double time_s = 0.0) const {
    Light light(site_, 0.0, Random(1));
    light.look_around(0.0, 0.0, time_s);
    Lit lit;
    light.on_floor({&x, 1}, {&y, 1}, {0.0, 0.0, 0.6}, {-5.0, 0.0}, 0.0, {&lit.gain, 1}, {&lit.shine, 1});
    return lit;
  }

  static constexpr float kMirrorX = 6.0F * 0.6F / 6.6F;  // where the lamp is mirrored: the angles agree
  Site site_;
};

TEST_F(LightOn, HalvedLightIsHalfAsBright) {
  const Lit before = at(1.0F, 0.2F);
  site_.change.light = 0.5;
  EXPECT_NEAR(at(1.0F, 0.2F).gain, before.gain / 2, 1e-5F);
}

TEST_F(LightOn, ALampThatHasFailedGivesNeitherLightNorShine) {
  site_.change.glare_grey = 160.0;
  const Lit before = at(kMirrorX, 0.0F);
  site_.change.lamps_failed = 1.0;
  EXPECT_LT(at(kMirrorX, 0.0F).gain, before.gain) << "what is left comes from everywhere";
  EXPECT_GT(at(kMirrorX, 0.0F).gain, 0.0F);
  EXPECT_EQ(at(kMirrorX, 0.0F).shine, 0.0F);
  site_.change.ambient = 0.0;
  EXPECT_EQ(at(kMirrorX, 0.0F).gain, 0.0F);
}

TEST_F(LightOn, ALampThatHasEndedIsAsOneThatHasFailed) {
  site_.lamps.front().ends_s = 5.0;
  const Lit before = at(1.0F, 0.2F, 4.9);
  const Lit after = at(1.0F, 0.2F, 5.0);
  site_.lamps.front().ends_s = 100.0;
  EXPECT_EQ(at(1.0F, 0.2F, 5.0).gain, before.gain);
  site_.change.lamps_failed = 1.0;
  EXPECT_EQ(at(1.0F, 0.2F, 5.0).gain, after.gain);
}

TEST_F(LightOn, GlareIsASpotWhereTheLampIsMirrored) {
  EXPECT_EQ(at(kMirrorX, 0.0F).shine, 0.0F);
  const float gain = at(kMirrorX, 0.0F).gain;
  site_.change.glare_grey = 160.0;
  EXPECT_GT(at(kMirrorX, 0.0F).shine, 80.0F);
  EXPECT_LT(at(kMirrorX, 0.2F).shine, 10.0F);
  EXPECT_EQ(at(kMirrorX, 0.0F).gain, gain);
  const float wide = at(kMirrorX, 0.05F).shine;
  site_.change.glare_size_m = 0.2;
  EXPECT_LT(at(kMirrorX, 0.05F).shine, 0.6F * wide);
}

TEST_F(LightOn, AWetFloorIsDarkerAndMirrorsTheLamp) {
  const Lit dry = at(kMirrorX, 0.0F);
  site_.change.wet.push_back({static_cast<double>(kMirrorX), 0.0, 0.4});
  const Lit wet = at(kMirrorX, 0.0F);
  EXPECT_LT(wet.gain, 0.7F * dry.gain);
  EXPECT_GT(wet.shine, 50.0F);
  EXPECT_EQ(at(kMirrorX, 1.0F).gain, dry.gain > 0.0F ? at(kMirrorX, -1.0F).gain : 0.0F);
}

TEST_F(LightOn, AShadowTakesItsShareWhereItIsAtThatTime) {
  const Lit before = at(1.0F, 0.0F);
  CastShadow shadow;
  shadow.site_from_shadow = {1.0, 0.0, 0.0};
  shadow.travel_m = 8.0;
  shadow.speed_m_s = 1.0;
  site_.change.shadows.push_back(shadow);
  site_.change.glare_grey = 100.0;
  EXPECT_NEAR(at(1.0F, 0.0F).gain, 0.5F * before.gain, 1e-4F);
  EXPECT_EQ(at(1.0F, 0.0F, 2.0).gain, before.gain);
  EXPECT_LT(at(1.0F, 0.0F).shine, 0.6F * at(1.0F, 0.0F, 2.0).shine);
}

}  // namespace
}  // namespace weft::agents::sim
