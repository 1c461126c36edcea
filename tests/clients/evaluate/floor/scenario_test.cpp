#include "clients/evaluate/floor/scenario.hpp"

#include <gtest/gtest.h>

namespace weft::evaluate::floor {
namespace {

using agents::SitePoint;

Stage stage() {
  Stage stage;
  stage.site.robots.push_back({"r1", {1.0, 2.0, 0.0}, 5});
  stage.line = {{1.0, 2.0}, {3.0, 2.0}, {3.0, 9.0}};
  stage.scratch = "truth.now";
  return stage;
}

TEST(FloorScenario, TheLongestStraightPart) {
  const std::vector<SitePoint> line = {{0, 0}, {1, 0}, {1, 1}, {1, 2}, {1.05, 4}, {5, 4}, {5, 3}};
  EXPECT_EQ(longest_straight(line), (std::vector<SitePoint>{{1, 0}, {1, 1}, {1, 2}, {1.05, 4}}));
  EXPECT_TRUE(longest_straight({{0, 0}}).empty());
}

TEST(FloorScenario, StretchesOfALine) {
  const std::vector<SitePoint> line = {{0, 0}, {4, 0}, {4, 6}};
  EXPECT_EQ(stretch(line, 0.0, 10.0), line);
  EXPECT_EQ(stretch(line, 1.0, 6.0), (std::vector<SitePoint>{{1, 0}, {4, 0}, {4, 2}}));
  EXPECT_EQ(stretch(line, 5.0, 6.0), (std::vector<SitePoint>{{4, 1}, {4, 2}}));
  EXPECT_EQ(stretch(line, 0.0, 99.0), line);
}

TEST(FloorScenario, TheTwoPartsOfTheLineOverlap) {
  const auto scenario = Scenario::make(stage(), "epoxy", 1);
  EXPECT_EQ(scenario->first_part().front(), (SitePoint{1.0, 2.0}));
  EXPECT_EQ(scenario->second_part().back(), (SitePoint{3.0, 9.0}));
  EXPECT_GT(scenario->first_part().back().y, scenario->second_part().front().y + 1.0);
  const Drive other = scenario->other_on_second_part();
  EXPECT_NEAR(other.body.site.robots.front().site_from_robot.y, scenario->second_part().front().y, 1e-9);
  EXPECT_NE(other.body.day, scenario->first().body.day);
}

TEST(FloorScenario, TheSecondRobotIsAnotherOneOnAnotherDay) {
  const auto scenario = Scenario::make(stage(), "epoxy", 3);
  ASSERT_TRUE(scenario.has_value()) << scenario.error().message;
  const Drive first = scenario->first();
  const auto second = scenario->second(lights().front());
  ASSERT_TRUE(second.has_value()) << second.error().message;
  EXPECT_NE(second->body.robot, first.body.robot);
  EXPECT_NE(second->body.site.robots.front().seed, first.body.site.robots.front().seed);
  EXPECT_NE(second->body.day, first.body.day);
  EXPECT_EQ(second->body.site.floor.seed, first.body.site.floor.seed);
  EXPECT_EQ(second->body.seed, first.body.seed);
}

TEST(FloorScenario, EachSeedIsAnotherPatchOfFloor) {
  const auto one = Scenario::make(stage(), "epoxy", 1);
  const auto two = Scenario::make(stage(), "epoxy", 2);
  EXPECT_NE(one->first().body.site.floor.seed, two->first().body.site.floor.seed);
}

TEST(FloorScenario, TheFastOneStartsWhereItsLineDoes) {
  const auto scenario = Scenario::make(stage(), "epoxy", 1);
  EXPECT_EQ(scenario->fast_line(), (std::vector<SitePoint>{{3.0, 2.0}, {3.0, 9.0}}));
  const Drive fast = scenario->fast();
  EXPECT_NEAR(fast.body.site.robots.front().site_from_robot.heading, 1.5707963, 1e-6);
  EXPECT_EQ(fast.body.site.hand.speed_m_s, 1.5);
  EXPECT_EQ(fast.body.site.camera.fps, 15.0);
}

TEST(FloorScenario, WhatThereIsNotIsRefused) {
  const auto kind = Scenario::make(stage(), "cheese", 1);
  ASSERT_FALSE(kind.has_value());
  EXPECT_NE(kind.error().message.find("cheese"), std::string::npos);
  const auto light = Scenario::make(stage(), "epoxy", 1)->second("disco");
  ASSERT_FALSE(light.has_value());
  EXPECT_NE(light.error().message.find("disco"), std::string::npos);
}

}  // namespace
}  // namespace weft::evaluate::floor
