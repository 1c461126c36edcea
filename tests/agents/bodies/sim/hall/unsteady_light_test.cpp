#include "agents/bodies/sim/hall/unsteady_light.hpp"

#include <gtest/gtest.h>

#include "tests/agents/bodies/sim/sites.hpp"

namespace weft::agents::sim {
namespace {

/// Returns a site with two lamps, of which the second flickers and ends at 10 s.
Site failing_site() {
  Site site = empty_site();
  site.lamps = {{6.0, 6.0, 6.0, 1.0}, {14.0, 6.0, 6.0, 1.0}};
  site.lamps[1].flicker = 0.8;
  site.lamps[1].ends_s = 10.0;
  site.disturbances.light_change = 0.0;
  return site;
}

Quad lying(float x, float z, Stuff stuff) {
  Quad quad;
  quad.corner = {x - 0.1F, 5.9F, z};
  quad.across = {0.2F, 0, 0};
  quad.up = {0, 0.2F, 0};
  quad.stuff = stuff;
  return quad;
}

const std::vector<Quad> kLitQuads = {lying(14.0F, 0.0F, Stuff::floor), lying(14.0F, 6.0F, Stuff::lamp),
                                     lying(6.0F, 6.0F, Stuff::lamp)};

TEST(UnsteadyLight, IsSteadyWhereNoLampChanges) {
  Site site = failing_site();
  EXPECT_FALSE(UnsteadyLight(HallLight(site, Random(1)), kLitQuads, nullptr).is_steady());
  site.lamps = {{6.0, 6.0, 6.0, 1.0}};
  EXPECT_TRUE(UnsteadyLight(HallLight(site, Random(1)), kLitQuads, nullptr).is_steady());
}

TEST(UnsteadyLight, IsTheLightOfTheLampsAsTheyAreThen) {
  const HallLight light(failing_site(), Random(1));
  const QuadScene scene(std::vector{lying(13.0F, 3.0F, Stuff::floor)});
  const UnsteadyLight unsteady(light, kLitQuads, &scene);
  for (const double time_s : {0.0, 0.3, 5.0, 12.0}) {
    const std::vector<QuadLight> told = unsteady.at(time_s);
    const std::vector<QuadLight> made = light.at_time(time_s).on(kLitQuads, &scene);
    for (std::size_t corner = 0; corner < 4; ++corner)
      EXPECT_NEAR(told[0].at[corner], made[0].at[corner], 1e-3F) << time_s;
    EXPECT_EQ(told[2].at, made[2].at) << "the other lamp shines as ever";
  }
}

TEST(UnsteadyLight, ALampThatHasEndedIsDark) {
  const UnsteadyLight unsteady(HallLight(failing_site(), Random(1)), kLitQuads, nullptr);
  const std::vector<QuadLight> before = unsteady.at(9.9);
  const std::vector<QuadLight> after = unsteady.at(10.0);
  EXPECT_GT(before[1].at[0], 2.0F);
  EXPECT_NEAR(after[1].at[0], 0.3F, 1e-3F);
  EXPECT_LT(after[0].at[0], 0.9F * before[0].at[0]);
  EXPECT_GT(after[0].at[0], 0.2F) << "light from everywhere stays";
}

}  // namespace
}  // namespace weft::agents::sim
