#include "agents/bodies/sim/hall/overhead.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "agents/bodies/sim/hall/hall_light.hpp"
#include "agents/bodies/sim/hall/interior.hpp"
#include "agents/bodies/sim/hall/quad_scene.hpp"
#include "tests/agents/bodies/sim/sites.hpp"

namespace weft::agents::sim {
namespace {

/// Returns a hall of 20 x 12 m and 6 m height under which only what a test hangs there is.
Site site_below() {
  Site site = empty_site();
  site.robots.front().looks = {Gaze::up};
  site.lamps.clear();
  site.hall.ceiling_m = 6.0;
  site.hall.ceiling.beams_every_m = 0.0;
  return site;
}

/// Returns how far above a camera at 0.5 m height the first thing is, straight up from there.
float above(const Site& site, float x, float y) {
  return QuadScene(interior_of(site)).distance_m({x, y, 0.5F}, Eigen::Vector3f::UnitZ());
}

TEST(Overhead, ADuctIsNearerThanTheCeilingAboveIt) {
  Site site = site_below();
  EXPECT_NEAR(above(site, 10.1F, 6.1F), 5.5F, 1e-4F);
  site.ducts.push_back({2.0, 6.0, 18.0, 6.0, 0.6, 0.6, 0.4});
  EXPECT_NEAR(above(site, 10.1F, 6.1F), 5.5F - 1.0F, 1e-4F);
  EXPECT_NEAR(above(site, 10.1F, 7.1F), 5.5F, 1e-4F) << "beside it";
}

TEST(Overhead, ANewDuctHangsThereFromItsDayOn) {
  Site site = site_below();
  site.change.ducts.push_back({2.0, 6.0, 18.0, 6.0, 0.6, 0.6, 0.4});
  EXPECT_NEAR(above(site, 10.1F, 6.1F), 4.5F, 1e-4F);
}

TEST(Overhead, APipeIsRoundAboutItsAxis) {
  Site site = site_below();
  site.pipes.push_back({2.0, 6.0, 18.0, 6.0, 0.5, 0.2});
  EXPECT_NEAR(above(site, 10.3F, 6.0F), 5.0F - 0.1F, 0.01F);
  EXPECT_GT(above(site, 10.3F, 6.08F), 5.0F - 0.09F);
  EXPECT_NEAR(above(site, 10.3F, 6.13F), 5.5F, 1e-4F);
}

TEST(Overhead, BeamsHaveALowerSideForThoseWhoLookUp) {
  Site site = site_below();
  site.hall.ceiling.beams_every_m = 5.0;
  EXPECT_NEAR(above(site, 2.55F, 6.0F), 5.5F - 0.35F, 1e-4F);
  EXPECT_NEAR(above(site, 5.0F, 6.0F), 5.5F, 1e-4F);
}

TEST(Overhead, WhoLooksAheadSeesTheBeamsAsEver) {
  Site site = empty_site();
  const auto beams = [](const Site& of) {
    std::vector<Quad> quads;
    add_overhead(of, quads);
    std::erase_if(quads, [](const Quad& quad) { return quad.stuff == Stuff::lamp; });
    return quads;
  };
  const std::vector<Quad> quads = beams(site);
  EXPECT_EQ(quads.size(), 4U * 5U) << "sides and top of four beams";
  EXPECT_TRUE(std::all_of(quads.begin(), quads.end(), [](const Quad& quad) { return quad.stuff == Stuff::steel; }));
}

TEST(Overhead, TheSheetIsSixCentimetresDeep) {
  Site site = site_below();
  site.hall.ceiling.kind = CeilingKind::sheet;
  const QuadScene scene(interior_of(site));
  float least = 10.0F;
  float most = 0.0F;
  for (int i = 0; i < 100; ++i) {
    const float far =
        scene.distance_m({8.0F + 0.0103F * static_cast<float>(i), 6.0F, 0.5F}, Eigen::Vector3f::UnitZ());
    least = std::min(least, far);
    most = std::max(most, far);
  }
  EXPECT_NEAR(least, 5.44F, 1e-3F);
  EXPECT_NEAR(most, 5.5F, 1e-3F);
}

TEST(Overhead, SprinklersAndSignsHangWhereTheyAreAskedFor) {
  Site site = site_below();
  const std::size_t none = interior_of(site).size();
  site.hall.ceiling.sprinklers_every_m = 3.0;
  const std::size_t sprinklers = interior_of(site).size();
  EXPECT_EQ(sprinklers - none, 12U * 28U) << "two boxes each";
  site.hall.ceiling.signs_every_m = 5.0;
  EXPECT_GT(interior_of(site).size(), sprinklers);
  for (const Quad& quad : interior_of(site)) EXPECT_LE(quad.at(0.5F, 0.5F).z(), 6.0F + 1e-4F);
}

TEST(Overhead, ASkylightShinesAsItsDaySays) {
  Site site = site_below();
  site.skylights.push_back({{10.0, 6.0, 0.0}, 2.0, 1.0, 0.5});
  const auto pane = [&] {
    std::vector<Quad> quads;
    add_overhead(site, quads);
    std::erase_if(quads, [](const Quad& quad) { return quad.stuff != Stuff::skylight; });
    EXPECT_EQ(quads.size(), 1U);
    return quads.front().grey * HallLight(site, Random(1)).on(quads, nullptr).front().at.front();
  };
  const float dusk = pane();
  EXPECT_GT(dusk, 500.0F) << "white, and more";
  site.change.skylight = 4.0;
  EXPECT_NEAR(pane(), 4.0F * dusk, 0.01F * dusk);
  Quad floor;
  floor.corner = {10.0F, 6.0F, 0.0F};
  floor.up = Eigen::Vector3f::UnitY();
  const auto lit = [&] { return HallLight(site, Random(1)).on(std::vector{floor}, nullptr).front().at.front(); };
  const float by_day = lit();
  site.change.skylight = 0.0;
  EXPECT_GT(by_day, 1.5F * lit());
}

}  // namespace
}  // namespace weft::agents::sim
