// Straight ways that nobody has driven, where they are seen to be free.
#include "agents/navigation/ways.hpp"
#include "tests/agents/navigation/roamer_fleet.hpp"

namespace weft::agents {
namespace {

using test::Course;
using test::NavigatedRobot;

class Shortcuts : public RoamerFleet {
 protected:
  void SetUp() override {
    navigation.teach.spacing_m = 0.5;
    navigation.teach.spacing_rad = 0.35;
  }
  /// Teaches a way out and back beside it, 2 m apart.
  void teach_a_bend() { teach(first, Course({5, 5, 0}).straight(3.0).turn(1.0, M_PI).straight(3.0).poses); }
  std::vector<Edge> found() const {
    std::vector<Edge> all;
    for (const Edge& edge : server.snapshot().experience(first)->stitches)
      if (edge.inliers == 0) all.push_back(edge);
    return all;
  }
};

TEST_F(Shortcuts, WhereAStraightIsClearItBecomesAnEdge) {
  noted->is_clear = [](const Pose2&, const Pose2&) { return true; };
  teach_a_bend();
  ASSERT_FALSE(found().empty());
  for (const Edge& edge : found()) {
    EXPECT_EQ(edge.origin, Origin::stitch);
    EXPECT_EQ(edge.drivable, Drivable::both);
    EXPECT_EQ(edge.method, "roamer");
    EXPECT_EQ(edge.id.a.experience, first);
    EXPECT_GE(edge.id.b.index, edge.id.a.index + 2);
    EXPECT_LE(distance_m(edge.a_from_b), 4.0);
    const Pose2 truly = truth.at(edge.id.a).inverse() * truth.at(edge.id.b);
    EXPECT_LT(test::distance(truly, planar(edge.a_from_b)), 0.1);
    EXPECT_GT(planar_covariance(edge.a_from_b)(0, 0), 0.0) << "that of the odometry on the way";
  }
}

TEST_F(Shortcuts, WhereNoneIsClearThereIsNone) {
  noted->is_clear = [](const Pose2&, const Pose2&) { return false; };
  teach_a_bend();
  EXPECT_FALSE(noted->asked_clear.empty());
  EXPECT_TRUE(found().empty());
}

TEST_F(Shortcuts, LanesBesideEachOtherAreJoinedFarFromTheirBend) {
  noted->is_clear = [](const Pose2&, const Pose2&) { return true; };
  teach(first, Course({5, 5, 0}).straight(9.0).turn(1.6, M_PI).straight(9.0).poses);
  std::uint32_t farthest = 0;
  for (const Edge& edge : found()) farthest = std::max(farthest, edge.id.b.index - edge.id.a.index);
  EXPECT_GT(farthest, 40U) << "that of the lanes' ends leaves out 20 m";
}

TEST_F(Shortcuts, TwoAreAskedForAPlaceAtMost) {
  teach_a_bend();
  const std::size_t places = server.snapshot().experience(first)->places.size();
  EXPECT_GT(noted->asked_clear.size(), places / 4);
  EXPECT_LE(noted->asked_clear.size(), 2 * places);
  for (const auto& [centre_from_a, a_from_b] : noted->asked_clear) {
    const Pose2 centre_from_b = centre_from_a * a_from_b;
    EXPECT_LT(centre_from_b.translation().norm(), 1e-9) << "b is the kept place, the chart's centre";
  }
}

TEST_F(Shortcuts, OnAStraightWayThereAreNoneToAskFor) {
  noted->is_clear = [](const Pose2&, const Pose2&) { return true; };
  teach(first, Course({5, 5, 0}).straight(8.0).poses);
  EXPECT_TRUE(noted->asked_clear.empty());
}

TEST_F(Shortcuts, WithoutStitchesNothingIsCutShort) {
  navigation.stitch.enabled = false;
  noted->is_clear = [](const Pose2&, const Pose2&) { return true; };
  teach_a_bend();
  EXPECT_TRUE(noted->asked_clear.empty());
}

TEST_F(Shortcuts, AnotherRobotDrivesThem) {
  noted->is_clear = [](const Pose2&, const Pose2&) { return true; };
  teach_a_bend();
  NavigatedRobot robot = localised_at(truth.at({first, 0}), {first, 0}, 2);
  const PlaceId goal = last_of(first);
  const Route route = server.route({first, 0}, goal, method());
  double way_m = 0.0;
  for (const Relation& hop : route.relations) way_m += distance_m(hop);
  EXPECT_LT(way_m, 0.5 * (3.0 + M_PI + 3.0));
  double driven_m = 0.0;
  Pose2 before = robot.world_from_robot();
  const Driven driven = drive(robot, route, 1.0, [&](const Navigated&) {
    driven_m += test::distance(before, robot.world_from_robot());
    before = robot.world_from_robot();
  });
  EXPECT_EQ(driven.last.following, Following::arrived) << driven.last.reason;
  EXPECT_LT(driven_m, way_m + 0.5);
  EXPECT_LT(test::distance(robot.world_from_robot(), truth.at(goal)), 0.07);
}

/// Returns a chain of places 0.5 m apart along these headings.
Window chain(const std::vector<double>& turns_rad) {
  Window window;
  for (std::uint32_t i = 0; i <= turns_rad.size(); ++i) {
    const PlaceId id{{3}, i};
    Place place;
    place.id = id;
    window.places.emplace(id, place);
    if (i == 0) continue;
    Edge edge;
    edge.id = {{{3}, i - 1}, id};
    edge.a_from_b = Metric2{{0.5, 0.0, turns_rad[i - 1]}, 1e-6 * Eigen::Matrix3d::Identity()};
    edge.drivable = Drivable::both;
    window.edges.emplace(edge.id, edge);
  }
  index_edges(window);
  return window;
}

TEST(WorthCutting, TheOneThatSavesMostComesFirst) {
  const Window window = chain({0.0, 0.0, M_PI / 2, 0.0, M_PI / 2, 0.0, 0.0});
  const PlaceId kept{{3}, 7};
  const auto detours = worth_cutting(window, kept, breadth_first(window, kept, 12, 200));
  ASSERT_GE(detours.size(), 2U);
  EXPECT_EQ(detours.front().place, (PlaceId{{3}, 0}));
  for (std::size_t i = 1; i < detours.size(); ++i) EXPECT_LE(detours[i].saves_m, detours[i - 1].saves_m);
  for (const Detour& detour : detours) EXPECT_LT(detour.place.index, 6U) << "two hops at least";
}

TEST(WorthCutting, WhereAShortcutIsNoneElseIsWorthIt) {
  Window window = chain({0.0, 0.0, M_PI / 2, 0.0, M_PI / 2, 0.0, 0.0});
  Edge shortcut;
  shortcut.id = {{{3}, 1}, {{3}, 7}};
  shortcut.a_from_b = Metric2{{0.0, 1.0, M_PI}, 1e-6 * Eigen::Matrix3d::Identity()};
  shortcut.drivable = Drivable::both;
  window.edges.emplace(shortcut.id, shortcut);
  index_edges(window);
  const PlaceId kept{{3}, 7};
  EXPECT_TRUE(worth_cutting(window, kept, breadth_first(window, kept, 12, 200)).empty());
}

}  // namespace
}  // namespace weft::agents
