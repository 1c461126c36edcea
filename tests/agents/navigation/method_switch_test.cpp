#include "agents/navigation/method_switch.hpp"

#include <gtest/gtest.h>

namespace weft::agents {
namespace {

constexpr ExperienceId kFloor{1};
constexpr ExperienceId kAhead{2};

/// Returns two runs beside each other, joined at their third places; place i lies at x = 0.2 i metres.
Window two_runs() {
  Window window;
  const auto add = [&](ExperienceId run, const std::string& method, bool metric) {
    for (std::uint32_t i = 0; i < 6; ++i) {
      Place place;
      place.id = {run, i};
      place.method = method;
      window.places.emplace(place.id, place);
      if (i == 0) continue;
      Edge edge;
      edge.id = {{run, i - 1}, place.id};
      edge.method = method;
      edge.a_from_b = metric ? Relation(Metric2{Pose2{0.2, 0.0, 0.0}, 1e-4 * Eigen::Matrix3d::Identity()})
                             : Relation(AlongPath{0.2, 1e-4, 0.0, 1e-4});
      window.edges.emplace(edge.id, edge);
    }
  };
  add(kFloor, "floor", true);
  add(kAhead, "along", false);
  Edge change;
  change.id = {{kFloor, 2}, {kAhead, 2}};
  change.method = change_between("floor", "along");
  change.origin = Origin::stitch;
  change.a_from_b = Metric2{};
  window.edges.emplace(change.id, change);
  index_edges(window);
  return window;
}

Route route_over_the_change() {
  Route route;
  route.places = {{kFloor, 1}, {kFloor, 2}, {kAhead, 2}, {kAhead, 3}};
  route.relations = {Metric2{Pose2{0.2, 0.0, 0.0}}, Metric2{}, AlongPath{0.2, 0.0, 0.0, 0.0}};
  route.released = 3;
  return route;
}

TEST(HandOver, AChangeIsNamedAlikeBothWays) {
  EXPECT_EQ(change_between("floor", "along"), "along+floor");
  EXPECT_EQ(change_between("along", "floor"), "along+floor");
}

TEST(HandOver, WhereItIsInTheOtherMap) {
  const Window window = two_runs();
  const Estimate known{{kFloor, 3}, Metric2{Pose2{0.02, 0.0, 0.0}}, 0.1};
  const auto ahead = as_seen_by("along", {}, window, known);
  ASSERT_TRUE(ahead);
  EXPECT_EQ(ahead->place, (PlaceId{kAhead, 3})) << "the nearest, not the one that is joined";
  EXPECT_NEAR(distance_m(ahead->place_from_robot), 0.02, 1e-9);
  EXPECT_EQ(ahead->blind_m, 0.1);
}

TEST(HandOver, WhoKnowsNoSideHandsOverAPoseThatMayBeASideOff) {
  const auto down = as_seen_by("floor", {}, two_runs(), {{kAhead, 4}, AlongPath{0.05, 1e-4, 0.02, 1e-4}, 0.0});
  ASSERT_TRUE(down);
  EXPECT_EQ(down->place, (PlaceId{kFloor, 4}));
  const auto& pose = std::get<Metric2>(down->place_from_robot);
  EXPECT_NEAR(pose.a_from_b.x, 0.05, 1e-3);
  EXPECT_NEAR(std::sqrt(pose.covariance(1, 1)), 0.15, 1e-9);
}

TEST(HandOver, MapsThatAreNotJoinedSayNothing) {
  Window window = two_runs();
  window.edges.erase_all({EdgeId{{kFloor, 2}, {kAhead, 2}}});
  index_edges(window);
  const Estimate floor{{kFloor, 3}, Metric2{}, 0.0};
  EXPECT_FALSE(as_seen_by("along", {}, window, floor));
  EXPECT_FALSE(agree({}, window, floor, {{kAhead, 3}, AlongPath{}, 0.0}));
}

TEST(HandOver, TwoThatContradictDoNotAgree) {
  const Window window = two_runs();
  const Estimate floor{{kFloor, 3}, Metric2{}, 0.0};
  EXPECT_TRUE(agree({}, window, floor, {{kAhead, 2}, AlongPath{0.25, 0.0, 0.05, 0.0}, 0.0}));
  EXPECT_FALSE(agree({}, window, floor, {{kAhead, 0}, AlongPath{}, 0.0})) << "0.6 m off";
  EXPECT_FALSE(agree({}, window, floor, {{kAhead, 3}, AlongPath{0.0, 0.0, 0.5, 0.0}, 0.0})) << "turned";
}

TEST(HandOver, TheNextPlaceSaysWhoDrives) {
  const Window window = two_runs();
  const Route route = route_over_the_change();
  EXPECT_EQ(next_method(window, route, 0), "floor");
  EXPECT_EQ(next_method(window, route, 1), "along");
  EXPECT_EQ(next_method(window, route, 3), "along") << "at its end the last one";
  EXPECT_EQ(next_method({}, route, 0), "") << "not in the window";
}

TEST(Joins, SayWhatDrivingOverThemNeeds) {
  const Window window = two_runs();
  Joins joins({});
  const auto edge =
      joins.join({{kFloor, 4}, Metric2{Pose2{0.05, 0.0, 0.0}}, 0.0}, "floor", *window.place({kAhead, 4}));
  ASSERT_TRUE(edge);
  EXPECT_EQ(edge->id, (EdgeId{{kFloor, 4}, {kAhead, 4}}));
  EXPECT_EQ(edge->method, "along+floor");
  EXPECT_EQ(edge->origin, Origin::stitch);
  EXPECT_EQ(edge->drivable, Drivable::both);
}

TEST(Joins, OneForEachOlderPlace) {
  const Window window = two_runs();
  Joins joins({});
  const Estimate here{{kFloor, 4}, Metric2{}, 0.0};
  EXPECT_TRUE(joins.join(here, "floor", *window.place({kAhead, 4})));
  EXPECT_FALSE(joins.join(here, "floor", *window.place({kAhead, 5})));
  EXPECT_TRUE(joins.join({{kFloor, 5}, Metric2{}, 0.0}, "floor", *window.place({kAhead, 5})));
}

}  // namespace
}  // namespace weft::agents
