#include "agents/bodies/sim/changes.hpp"

#include <gmock/gmock.h>

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

}  // namespace
}  // namespace weft::agents::sim
