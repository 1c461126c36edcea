#include "server/traffic/holdings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"
#include "tests/server/surveyed_site.hpp"

namespace weft::server::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kHeldReach_m = 0.5;

/// Arranges a figure of eight, and a lane that leads along it and across it again.
SurveyedSite crossing_site(std::uint64_t seed) {
  SurveyedSite site(seed);
  constexpr double pi = std::numbers::pi;
  const std::uint64_t eight = site.teach(Lane({-4.0, 0.0, 0.0}).ahead(8.0).bend(1.5 * pi, 18.0).ahead(8.0));
  const std::uint64_t other = site.teach(Lane({-4.0, 0.3, 0.0}).ahead(12.0).bend(pi, 3.0).ahead(12.0));
  site.stitch(SurveyedSite::place(eight, 0), SurveyedSite::place(other, 0));
  return site;
}

/// Compares what several robots hold, asked of the index and of each holding.
struct HoldingsTest : testing::Test {
  void put(std::uint8_t robot, std::uint64_t run, std::uint32_t from, std::uint32_t to) {
    std::vector<Touched> touched;
    for (std::uint32_t i = from; i <= to; ++i) touched.push_back({SurveyedSite::place(run, i), kHeldReach_m});
    held[robot_id(robot)] = touched;
    holdings.put(site.network(), proximity, robot_id(robot), touched);
  }
  std::set<RobotId> near(const PlaceId& place, const RobotId& except = {}) {
    return holdings.near(site.network(), proximity, proximity.locate(site.network(), {place, kHeldReach_m}), except);
  }
  void expect_as_each_says() {
    for (std::uint64_t run = 1; run <= 2; ++run) {
      for (std::uint32_t i = 0; i < site.places(run); ++i) {
        const Touched here{SurveyedSite::place(run, i), kHeldReach_m};
        std::set<RobotId> each;
        for (const auto& [robot, touched] : held) {
          if (proximity.overlap(site.network(), {here}, touched)) each.insert(robot);
        }
        EXPECT_EQ(near(here.place), each) << run << ":" << i;
        for (const auto& [robot, touched] : held) {
          const LocatedPlace located = proximity.locate(site.network(), here);
          EXPECT_EQ(holdings.holds_near(site.network(), proximity, robot, located), each.contains(robot));
        }
      }
    }
  }

  SurveyedSite site = crossing_site(1);
  Proximity proximity = proximity_of(site.network());
  Holdings holdings;
  std::map<RobotId, std::vector<Touched>> held;
};

TEST_F(HoldingsTest, AnswersAsEachHoldingDoes) {
  put(1, 1, 0, 20);
  put(2, 1, 60, 60);
  put(3, 2, 30, 55);
  put(4, 2, 80, 84);
  expect_as_each_says();
}

TEST_F(HoldingsTest, WhatIsFreedAndWhatIsGivenIsTakenIn) {
  put(1, 1, 0, 40);
  put(2, 2, 0, 20);
  put(1, 1, 17, 40);  // freed
  put(1, 1, 17, 60);  // released
  put(1, 1, 30, 70);  // both
  put(2, 1, 90, 95);  // elsewhere
  expect_as_each_says();
  put(1, 1, 1, 0);
  held[robot_id(1)].clear();
  expect_as_each_says();
}

TEST_F(HoldingsTest, OneOfThemIsLeftOut) {
  put(1, 1, 10, 12);
  put(2, 1, 13, 13);
  EXPECT_THAT(near(SurveyedSite::place(1, 12)), ElementsAre(robot_id(1), robot_id(2)));
  EXPECT_THAT(near(SurveyedSite::place(1, 12), robot_id(1)), ElementsAre(robot_id(2)));
  EXPECT_THAT(near(SurveyedSite::place(1, 60)), IsEmpty());
}

TEST_F(HoldingsTest, StitchThatJoinsTwoFloorsIsTakenIn) {
  site = SurveyedSite(2);
  const std::uint64_t a = site.teach(Lane({}).ahead(10.0));
  const std::uint64_t b = site.teach(Lane({0.0, 0.2, 0.0}).ahead(10.0));
  proximity = proximity_of(site.network());
  put(1, a, 0, 8);
  put(2, b, 20, 25);
  EXPECT_THAT(near(SurveyedSite::place(b, 4)), IsEmpty());
  Batch batch;
  batch.experience = ExperienceId{b};
  const Edge stitch = site.stitch(SurveyedSite::place(a, 4), SurveyedSite::place(b, 4));
  batch.edges.push_back(stitch);
  const auto different = proximity.joined(std::make_shared<const Snapshot>(site.network()), batch);
  proximity.layout().work(1'000'000);
  holdings.refresh(site.network(), proximity, different);
  holdings.refresh_all(site.network(), proximity);
  EXPECT_THAT(near(SurveyedSite::place(b, 4)), ElementsAre(robot_id(1)));
  expect_as_each_says();
}

TEST_F(HoldingsTest, RisesWithTheWayFromWhatIsHeld) {
  put(1, 1, 0, 4);
  double before_m = 0.0;
  for (std::uint32_t i = 5; i < 20; ++i) {
    const LocatedPlace here = proximity.locate(site.network(), {SurveyedSite::place(1, i), kHeldReach_m});
    const std::optional<double> clearance_m = holdings.clearance_m(proximity, robot_id(1), here);
    ASSERT_TRUE(clearance_m);
    EXPECT_GT(*clearance_m, before_m);
    before_m = *clearance_m;
  }
}

}  // namespace
}  // namespace weft::server::test
