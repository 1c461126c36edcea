// Checks how a site file says how much there is to see on a wall, and how a lamp shines.
#include <gmock/gmock.h>

#include <algorithm>

#include "agents/bodies/sim/lamps.hpp"

namespace weft::agents::sim {
namespace {

using testing::HasSubstr;

constexpr const char* kWalledSite = R"(
name = "walled"
[floor]
x_min = 0
y_min = 0
x_max = 5
y_max = 4
[[robot]]
name = "r1"
x = 1
y = 2
)";

std::string refusal_of_walled(const std::string& more) {
  const auto site = parse_site(std::string(kWalledSite) + more, "walled.toml");
  return site ? std::string("nothing is wrong") : site.error().message;
}

TEST(WallKeys, AWallIsAsRichAsItSays) {
  const auto site = parse_site(std::string(kWalledSite) + R"(
[[wall]]
from = [0, 0]
to = [5, 0]
[[wall]]
from = [0, 4]
to = [5, 4]
plain = true
[[wall]]
from = [5, 0]
to = [5, 4]
contrast = 0.2
)",
                               "walled.toml");
  ASSERT_TRUE(site) << site.error().message;
  ASSERT_EQ(site->boxes.size(), 3U);
  EXPECT_EQ(site->boxes[0].contrast, 1.0);
  EXPECT_TRUE(site->boxes[0].has_signs);
  EXPECT_EQ(site->boxes[1].contrast, 0.02);
  EXPECT_FALSE(site->boxes[1].has_signs);
  EXPECT_EQ(site->boxes[2].contrast, 0.2);
  EXPECT_TRUE(site->boxes[2].has_signs);
}

TEST(WallKeys, WhatContradictsItselfIsRefused) {
  const std::string wall = "[[wall]]\nfrom = [0, 0]\nto = [5, 0]\n";
  const std::string both = refusal_of_walled(wall + "plain = true\ncontrast = 0.5\n");
  EXPECT_THAT(both, HasSubstr("walled.toml:16"));
  EXPECT_THAT(both, HasSubstr("leave out one of them"));
  EXPECT_THAT(refusal_of_walled(wall + "contrast = 1.5\n"), HasSubstr("contrast"));
  EXPECT_THAT(refusal_of_walled(wall + "plain = 1\n"), HasSubstr("plain"));
  EXPECT_THAT(refusal_of_walled("[[pillar]]\nx = 4\ny = 3\nplain = true\n"), HasSubstr("plain"));
}

TEST(LampKeys, ALampShinesForEverUnlessItIsSaid) {
  const auto site = parse_site(std::string(kWalledSite) + R"(
[[lamp]]
x = 1
y = 1
[[lamp]]
x = 2
y = 1
flicker_percent = 60
flicker_hz = 5
ends_s = 40
[[lamp_grid]]
x = 0.5
y = 3
apart_x_m = 1
apart_y_m = 1
columns = 2
rows = 1
ends_s = 7
)",
                               "walled.toml");
  ASSERT_TRUE(site) << site.error().message;
  ASSERT_EQ(site->lamps.size(), 4U);
  EXPECT_FALSE(is_unsteady(site->lamps[0]));
  EXPECT_TRUE(is_unsteady(site->lamps[1]));
  EXPECT_EQ(site->lamps[1].flicker, 0.6);
  EXPECT_EQ(site->lamps[1].flicker_hz, 5.0);
  EXPECT_EQ(site->lamps[1].ends_s, 40.0);
  EXPECT_EQ(site->lamps[3].ends_s, 7.0);
  EXPECT_THAT(refusal_of_walled("[[lamp]]\nx = 1\ny = 1\nflicker_percent = 101\n"), HasSubstr("flicker_percent"));
  EXPECT_THAT(refusal_of_walled("[[lamp]]\nx = 1\ny = 1\nends_s = -1\n"), HasSubstr("ends_s"));
}

TEST(Lamps, AFlickeringLampIsAnotherOneAtATime) {
  Lamp lamp{1.0, 2.0, 6.0, 1.0};
  EXPECT_EQ(share_at(lamp, 3.0), 1.0);
  lamp.flicker = 0.6;
  lamp.flicker_hz = 10.0;
  double least = 1.0;
  double most = 0.0;
  for (int i = 0; i < 200; ++i) {
    const double share = share_at(lamp, 0.1 * i + 0.01);
    EXPECT_EQ(share_at(lamp, 0.1 * i + 0.09), share) << "the same for a tenth of a second";
    least = std::min(least, share);
    most = std::max(most, share);
  }
  EXPECT_GE(least, 0.4);
  EXPECT_LT(least, 0.5);
  EXPECT_LE(most, 1.0);
  EXPECT_GT(most, 0.9);
  Lamp other = lamp;
  other.x = 4.0;
  EXPECT_NE(share_at(other, 0.05), share_at(lamp, 0.05));
  lamp.ends_s = 8.0;
  EXPECT_GT(share_at(lamp, 7.9), 0.0);
  EXPECT_EQ(share_at(lamp, 8.0), 0.0);
}

}  // namespace
}  // namespace weft::agents::sim
