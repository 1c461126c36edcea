// Checks how a site file describes what robots run into.
#include <gmock/gmock.h>

#include <cmath>

#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {
namespace {

using testing::HasSubstr;

constexpr const char* kSolidSite = R"(
name = "solid"
[floor]
x_min = 0
y_min = 0
x_max = 9
y_max = 9
[[robot]]
name = "r1"
x = 1
y = 2
)";

std::string refusal_of_solid(const std::string& more) {
  const auto site = parse_site(std::string(kSolidSite) + more, "solid.toml");
  return site ? std::string("nothing is wrong") : site.error().message;
}

TEST(SolidKeys, ObstaclesStandThereForAWhile) {
  const auto site = parse_site(std::string(kSolidSite) + R"(
[[obstacle]]
x = 5
y = 4
heading_deg = 90
length_m = 1.2
height_m = 0.15
from_day = 2
[[obstacle]]
kind = "person"
name = "Kim"
x = 6
y = 4
from_s = 10
to_s = 20
[[obstacle]]
kind = "pallet-jack"
x = 7
y = 7
)",
                               "solid.toml");
  ASSERT_TRUE(site) << site.error().message;
  ASSERT_EQ(site->obstacles.size(), 3U);
  const Obstacle& crate = site->obstacles[0];
  EXPECT_EQ(crate.kind, Obstacle::Kind::crate);
  EXPECT_EQ(crate.name, "obstacle 1");
  EXPECT_NEAR(crate.site_from_obstacle.heading, M_PI / 2, 1e-12);
  EXPECT_EQ(crate.length_m, 1.2);
  EXPECT_EQ(crate.width_m, 0.6);
  EXPECT_EQ(crate.height_m, 0.15);
  EXPECT_EQ(crate.from_day, 2U);
  EXPECT_TRUE(crate.stands_at(1e9));
  const Obstacle& person = site->obstacles[1];
  EXPECT_EQ(person.name, "Kim");
  EXPECT_FALSE(person.stands_at(9.9));
  EXPECT_TRUE(person.stands_at(10.0));
  EXPECT_FALSE(person.stands_at(20.0));
  EXPECT_GT(site->obstacles[2].length_m, 1.5);
}

TEST(SolidKeys, MoversAreSolidAndPersonsPoliteUnlessItIsSaid) {
  const auto site = parse_site(std::string(kSolidSite) + R"(
[[person]]
way = [1, 1, 8, 1]
[[person]]
way = [1, 8, 8, 8]
name = "Ada"
rude = true
[[forklift]]
way = [1, 5, 8, 5]
solid = false
)",
                               "solid.toml");
  ASSERT_TRUE(site) << site.error().message;
  EXPECT_EQ(site->movers[0].name, "person 1");
  EXPECT_TRUE(site->movers[0].is_solid);
  EXPECT_FALSE(site->movers[0].is_rude);
  EXPECT_EQ(site->movers[1].name, "Ada");
  EXPECT_TRUE(site->movers[1].is_rude);
  EXPECT_EQ(site->movers[2].name, "forklift 1");
  EXPECT_FALSE(site->movers[2].is_solid);
}

TEST(SolidKeys, ARackMayBeLikeOneBefore) {
  const std::string first = "[[rack]]\nname = \"A\"\nx = 5\ny = 7\nlength_m = 2.7\nheight_m = 3\n";
  const auto site = parse_site(kSolidSite + first + "[[rack]]\nx = 5\ny = 4\nlike = \"A\"\n", "solid.toml");
  ASSERT_TRUE(site) << site.error().message;
  EXPECT_EQ(site->boxes[1].length_m, 2.7);
  EXPECT_EQ(site->boxes[1].height_m, 3.0);
  EXPECT_THAT(refusal_of_solid(first + "[[rack]]\nx = 5\ny = 4\nlike = \"B\"\n"), HasSubstr("\"B\""));
  EXPECT_THAT(refusal_of_solid("[[rack]]\nname = \"A\"\nx = 5\ny = 4\nlike = \"A\"\n"), HasSubstr("\"A\""));
  EXPECT_THAT(refusal_of_solid(first + "[[rack]]\nx = 5\ny = 4\nlike = \"A\"\nlength_m = 3\n"),
              HasSubstr("length_m"));
}

TEST(SolidKeys, WhatCannotBeIsRefused) {
  EXPECT_THAT(refusal_of_solid("[[obstacle]]\nx = 5\ny = 5\nkind = \"cow\"\n"), HasSubstr("pallet-jack"));
  EXPECT_THAT(refusal_of_solid("[[obstacle]]\nx = 5\n"), HasSubstr("obstacle[0].y"));
  EXPECT_THAT(refusal_of_solid("[[obstacle]]\nx = 5\ny = 5\nheight_m = 9\n"), HasSubstr("height_m"));
  EXPECT_THAT(refusal_of_solid("[[obstacle]]\nx = 5\ny = 5\nkind = \"person\"\nheight_m = 1\n"),
              HasSubstr("height_m"));
  EXPECT_THAT(refusal_of_solid("[[obstacle]]\nx = 5\ny = 5\nfrom_s = 4\nto_s = 3\n"),
              HasSubstr("greater than from_s"));
  EXPECT_THAT(refusal_of_solid("[[obstacle]]\nname = \"box\"\nx = 1.5\ny = 2\n"), HasSubstr("r1 would stand in box"));
  EXPECT_EQ(refusal_of_solid("[[obstacle]]\nx = 1.5\ny = 2\nfrom_s = 5\n"), "nothing is wrong");
  EXPECT_THAT(refusal_of_solid("[[forklift]]\nway = [1, 1, 2, 2]\nrude = true\n"), HasSubstr("rude"));
}

}  // namespace
}  // namespace weft::agents::sim
