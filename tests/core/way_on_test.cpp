#include "core/network/way_on.hpp"

#include <gtest/gtest.h>

#include "core/network/change.hpp"

namespace weft {
namespace {

/// Builds maps of runs whose places lie half a metre apart, joined by stitches.
class Map {
 public:
  /// Adds a run that ends on the place `joins`, if there is one.
  void run(std::uint64_t id, std::uint32_t places, const std::vector<Edge>& stitches = {},
           const std::string& method = "marks") {
    Batch batch;
    batch.experience = {id};
    batch.sequence = 1;
    batch.method = method;
    for (std::uint32_t index = 0; index < places; ++index) {
      Place place;
      place.id = {{id}, index};
      place.method = method;
      place.content.hash.bytes[0] = 1;
      place.content.size = 1;
      batch.places.push_back(place);
      if (index > 0) batch.edges.push_back(edge({{id}, index - 1}, place.id, 0.5, Drivable::a_to_b, method));
    }
    for (Edge stitch : stitches) {
      stitch.method = method;
      batch.edges.push_back(stitch);
    }
    snapshot_ = with(snapshot_, batch);
  }
  static Edge stitch(const PlaceId& older, const PlaceId& newer) {
    return edge(older, newer, 0.01, Drivable::both, "marks");
  }
  WayOn on(const PlaceId& place, const std::set<std::string>& methods = {"marks"}) const {
    return way_on(snapshot_, place, methods);
  }

 private:
  static Edge edge(const PlaceId& a, const PlaceId& b, double x_m, Drivable drivable, const std::string& method) {
    Edge made;
    made.id = {a, b};
    made.a_from_b = Metric2{{x_m, 0.0, 0.0}, Eigen::Matrix3d::Identity() * 1e-6};
    made.origin = drivable == Drivable::both ? Origin::stitch : Origin::odometry;
    made.method = method;
    made.drivable = drivable;
    return made;
  }

  Snapshot snapshot_;
};

PlaceId place_at(std::uint64_t run, std::uint32_t index) {
  return {{run}, index};
}

TEST(WayOnOf, EndOfARoadLeadsNowhere) {
  Map map;
  map.run(1, 20);
  const WayOn way = map.on(place_at(1, 15));
  EXPECT_FALSE(way.leads_on);
  EXPECT_EQ(way.places, 4U);
}

TEST(WayOnOf, RunThatClosesOnItselfLeadsOnFromEachOfItsPlaces) {
  Map map;
  map.run(1, 20, {Map::stitch(place_at(1, 5), place_at(1, 19))});
  EXPECT_TRUE(map.on(place_at(1, 0)).leads_on);
  EXPECT_TRUE(map.on(place_at(1, 19)).leads_on);
}

TEST(WayOnOf, TwoRunsOverOneRoadAreNoWayRound) {
  Map map;
  map.run(1, 20);
  std::vector<Edge> stitches;
  for (std::uint32_t index = 0; index < 20; ++index)
    stitches.push_back(Map::stitch(place_at(1, index), place_at(2, index)));
  map.run(2, 20, stitches);
  EXPECT_FALSE(map.on(place_at(2, 10)).leads_on);
}

TEST(WayOnOf, RoundThatALargerOneLeadsIntoAndNothingLeadsOutOfLeadsNowhere) {
  Map map;
  map.run(1, 40, {Map::stitch(place_at(1, 0), place_at(1, 39))});
  map.run(2, 10, {Map::stitch(place_at(2, 3), place_at(2, 9)), Map::stitch(place_at(1, 20), place_at(2, 0))});
  // Nothing leads back: the stitch at the beginning of the second run is left by its first place alone.
  EXPECT_FALSE(map.on(place_at(2, 8)).leads_on);
  EXPECT_TRUE(map.on(place_at(1, 10)).leads_on);
}

TEST(WayOnOf, RoadThatLeadsToARoundIsNoPlaceToGoBackTo) {
  Map map;
  map.run(1, 30, {Map::stitch(place_at(1, 20), place_at(1, 29))});
  EXPECT_TRUE(map.on(place_at(1, 25)).leads_on);
}

TEST(WayOnOf, OnlyWhatTheRobotDrivesCounts) {
  Map map;
  map.run(1, 20, {Map::stitch(place_at(1, 5), place_at(1, 19))}, "other");
  EXPECT_FALSE(map.on(place_at(1, 10)).leads_on);
  EXPECT_TRUE(map.on(place_at(1, 10), {"marks", "other"}).leads_on);
}

TEST(WayOnOf, WhatLeadsOnFartherThanIsLookedAtLeadsOn) {
  Map map;
  map.run(1, 6000);
  EXPECT_TRUE(map.on(place_at(1, 10)).leads_on);
  EXPECT_FALSE(map.on(place_at(1, 5500)).leads_on);
}

}  // namespace
}  // namespace weft
