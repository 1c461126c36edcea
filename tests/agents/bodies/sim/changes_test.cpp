#include "agents/bodies/sim/changes.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "agents/bodies/sim/floor/procedural.hpp"
#include "sites.hpp"

namespace weft::agents::sim {
namespace {

using testing::HasSubstr;

TEST(Changes, EveryKindIsAFloor) {
  for (const std::string& kind : floor_kinds()) {
    const auto site = on_floor(empty_site(), kind);
    ASSERT_TRUE(site) << site.error().message;
    EXPECT_TRUE(make_procedural_floor(site->floor)) << kind;
  }
}

TEST(Changes, AnUnknownNameIsRefusedWithThoseThereAre) {
  const auto floor = on_floor(empty_site(), "snow");
  ASSERT_FALSE(floor);
  EXPECT_THAT(floor.error().message, HasSubstr("\"snow\"; there are concrete, "));
  const auto light = under_light(empty_site(), "dark");
  ASSERT_FALSE(light);
  EXPECT_THAT(light.error().message, HasSubstr("same, halved"));
  const auto wear = with_wear(empty_site(), "holes");
  ASSERT_FALSE(wear);
  EXPECT_THAT(wear.error().message, HasSubstr("same"));
}

TEST(Changes, EveryNameButTheFirstChangesTheSite) {
  const Change none;
  for (const std::string& name : light_names()) {
    const auto site = under_light(empty_site(), name);
    ASSERT_TRUE(site) << site.error().message;
    EXPECT_EQ(site->change == none, name == "same") << name;
  }
  for (const std::string& name : wear_names()) {
    const auto site = with_wear(empty_site(), name);
    ASSERT_TRUE(site) << site.error().message;
    EXPECT_EQ(site->change == none, name == "same") << name;
  }
}

TEST(Changes, AHallOfAnySizeHoldsNoMoreThanASiteFileMayList) {
  Site vast = empty_site();
  vast.floor.x_min = vast.floor.y_min = -1000.0;
  vast.floor.x_max = vast.floor.y_max = 1000.0;
  EXPECT_LE(under_light(vast, "moving-shadow")->change.shadows.size(), 1000U);
  EXPECT_LE(with_wear(vast, "wet")->change.wet.size(), 1000U);
  EXPECT_LE(with_wear(vast, "line")->change.lines.size(), 1000U);
}

TEST(Changes, GlareWantsALamp) {
  Site dark = empty_site();
  dark.lamps.clear();
  const auto site = under_light(dark, "glare");
  ASSERT_FALSE(site);
  EXPECT_THAT(site.error().message, HasSubstr("no [[lamp]]"));
}

TEST(Changes, ARobotMeetsThemWhereverItDrives) {
  const Site site = empty_site();
  const auto wet = with_wear(site, "wet");
  for (double x = 2.0; x < 18.0; x += 1.0) {
    double nearest = 1e9;
    for (const WetArea& area : wet->change.wet) nearest = std::min(nearest, std::hypot(area.x - x, area.y - 6.0));
    EXPECT_LT(nearest, 3.0) << x;
  }
}

}  // namespace
}  // namespace weft::agents::sim
