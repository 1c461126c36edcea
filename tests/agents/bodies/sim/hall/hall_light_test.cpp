#include "agents/bodies/sim/hall/hall_light.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/agents/bodies/sim/sites.hpp"

namespace weft::agents::sim {
namespace {

Quad level(float x, float y, float z, float side, Stuff stuff = Stuff::floor) {
  Quad quad;
  quad.corner = {x - side / 2, y - side / 2, z};
  quad.across = {side, 0, 0};
  quad.up = {0, side, 0};
  quad.stuff = stuff;
  return quad;
}

/// Returns a site with one lamp, at (10, 6, 6), and as much light again from everywhere.
Site lit_site() {
  Site site = empty_site();
  site.lamps = {{10.0, 6.0, 6.0, 1.0}};
  site.disturbances.light_change = 0.0;
  return site;
}

float light_at(const Site& site, const Quad& quad, const std::vector<Quad>& in_the_way = {}) {
  const QuadScene scene(in_the_way);
  const QuadLight light = HallLight(site, Random(1)).on(std::vector{quad}, &scene).front();
  return std::accumulate(light.at.begin(), light.at.end(), 0.0F) / 4.0F;  // in its middle
}

TEST(HallLight, IsBrightestUnderTheLamp) {
  const float under = light_at(lit_site(), level(10, 6, 0, 0.1F));
  const float far = light_at(lit_site(), level(19, 11, 0, 0.1F));
  EXPECT_GT(under, 1.5F * far);
  EXPECT_GT(far, 0.3F);
  EXPECT_LT(under, 2.5F);
}

TEST(HallLight, ThingsThrowShadows) {
  const float open = light_at(lit_site(), level(10, 6, 0, 0.1F));
  const float shaded = light_at(lit_site(), level(10, 6, 0, 0.1F), {level(10, 6, 3, 1.0F)});
  EXPECT_NEAR(shaded, 0.5F * open, 0.02F * open) << "light from everywhere stays";
}

TEST(HallLight, FailedLampsAreDarkAndStayTheSame) {
  Site site = lit_site();
  site.change.lamps_failed = 1.0;
  const float open = light_at(lit_site(), level(10, 6, 0, 0.1F));
  EXPECT_NEAR(light_at(site, level(10, 6, 0, 0.1F)), 0.5F * open, 0.02F * open);
  site.change.lamps_failed = 0.0;
  site.change.light = 0.25;
  EXPECT_NEAR(light_at(site, level(10, 6, 0, 0.1F)), 0.25F * open, 0.01F * open);
}

/// Shows that a hall at night is dark: the camera's exposure is set for the hall as it is by day.
TEST(HallLight, AHallAtNightIsDark) {
  Site site = lit_site();
  const float open = light_at(site, level(10, 6, 0, 0.1F));
  site.change.lamps_failed = 1.0;
  site.change.ambient = 0.02;
  EXPECT_NEAR(light_at(site, level(10, 6, 0, 0.1F)), 0.01F * open, 0.001F * open);
}

TEST(HallLight, HalfOfTheLampsAreHalfOfThem) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    Site site = lit_site();
    site.lamps.clear();
    for (int i = 0; i < 8; ++i) site.lamps.push_back({1.0 + 2.0 * i, 6.0, 6.0, 1.0});
    site.change.seed = seed;
    site.change.lamps_failed = 0.5;
    int shining = 0;
    for (const Lamp& lamp : site.lamps) {
      const Quad face = level(static_cast<float>(lamp.x), 6, 6, 0.3F, Stuff::lamp);
      shining += light_at(site, face) > 5.0F ? 1 : 0;
    }
    EXPECT_EQ(shining, 4) << seed;
  }
}

TEST(HallLight, ALampShinesByItself) {
  Quad face = level(10, 6, 6, 0.3F, Stuff::lamp);
  EXPECT_GT(light_at(lit_site(), face), 5.0F);
  Site site = lit_site();
  site.change.lamps_failed = 1.0;
  EXPECT_LT(light_at(site, face), 0.5F);
}

}  // namespace
}  // namespace weft::agents::sim
