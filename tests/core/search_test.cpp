#include "core/network/search.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "tests/support/network_maker.hpp"

namespace weft {
namespace {

using support::BatchPlan;
using support::make_network;
using support::pick_place;
using testing::HasSubstr;

std::vector<PlaceId> all_places(const Snapshot& snapshot) {
  std::vector<PlaceId> ids;
  for (const auto& [id, experience] : snapshot.experiences()) {
    for (const Place& place : experience->places) ids.push_back(place.id);
  }
  return ids;
}

/// Hops by relaxing every edge until nothing changes.
std::map<PlaceId, std::uint32_t> hops_from(const Snapshot& snapshot, const PlaceId& centre) {
  std::map<PlaceId, std::uint32_t> hops{{centre, 0}};
  for (bool changed = true; changed;) {
    changed = false;
    for (const PlaceId& id : all_places(snapshot)) {
      if (!hops.contains(id)) continue;
      snapshot.for_each_edge(id, [&](const Edge& edge) {
        const auto [at, added] = hops.emplace(other_end(edge, id), hops[id] + 1);
        if (!added && at->second > hops[id] + 1)
          at->second = hops[id] + 1;
        else if (!added)
          return;
        changed = true;
      });
    }
  }
  return hops;
}

TEST(Within, GivesWhatAChainOfHopsLeadsToThatKeepsNear) {
  Random random(43);
  for (int round = 0; round < 20; ++round) {
    const Snapshot snapshot = make_network(random, 3, 3, 4, 2);
    const PlaceId centre = pick_place(random, snapshot);
    const std::vector<Reached> all = breadth_first(snapshot, centre, 1000, 1000);
    const std::vector<Reached> far = within(snapshot, centre, 1e9, 1000);
    EXPECT_EQ(far.size(), all.size());
    const std::vector<Reached> near = within(snapshot, centre, 1.0, 1000);
    ASSERT_FALSE(near.empty());
    EXPECT_EQ(near.front().id, centre);
    for (std::size_t at = 1; at < near.size(); ++at) {
      EXPECT_LE(distance_m(near[at].centre_from_place), 1.0);
      EXPECT_GE(near[at].depth, near[at - 1].depth);
    }
    EXPECT_LE(within(snapshot, centre, 1e9, 3).size(), 3U);
  }
  EXPECT_TRUE(within(Snapshot{}, {ExperienceId{1}, 0}, 1.0, 10).empty());
}

TEST(BreadthFirst, GivesNearestHopsFirstTiesById) {
  Random random(41);
  for (int round = 0; round < 20; ++round) {
    const Snapshot snapshot = make_network(random, 3, 3, 4, 2);
    const PlaceId centre = pick_place(random, snapshot);
    const auto hops = hops_from(snapshot, centre);
    std::vector<std::pair<std::uint32_t, PlaceId>> expected;
    for (const auto& [id, depth] : hops) {
      if (depth <= 4) expected.push_back({depth, id});
    }
    std::sort(expected.begin(), expected.end());
    const std::vector<Reached> reached = breadth_first(snapshot, centre, 4, 1000);
    ASSERT_EQ(reached.size(), expected.size());
    for (std::size_t i = 0; i < reached.size(); ++i) {
      EXPECT_EQ(reached[i].depth, expected[i].first);
      EXPECT_EQ(reached[i].id, expected[i].second);
    }
    const auto cap = static_cast<std::uint32_t>(1 + random.below(expected.size()));
    const std::vector<Reached> capped = breadth_first(snapshot, centre, 4, cap);
    const std::vector<PlaceId> ids = neighbourhood(snapshot, centre, 4, cap);
    ASSERT_EQ(capped.size(), cap);
    ASSERT_EQ(ids.size(), cap);
    for (std::size_t i = 0; i < capped.size(); ++i) {
      EXPECT_EQ(capped[i].id, reached[i].id);
      EXPECT_EQ(ids[i], reached[i].id);
    }
  }
}

TEST(BreadthFirst, ComposesTheOdometryOfAChain) {
  Random random(42);
  const BatchPlan plan{ExperienceId{5}, support::random_id<RobotId>(random), 1, 30, 0, "marks"};
  const Snapshot snapshot = with(Snapshot{}, support::make_batch(random, Snapshot{}, plan));
  const Experience& experience = *snapshot.experience(plan.experience);
  for (const Reached& reached : breadth_first(snapshot, {plan.experience, 10}, 25, 1000)) {
    Pose2 expected;
    for (std::uint32_t i = 10; i < reached.id.index; ++i) expected = expected * planar(experience.chain[i].a_from_b);
    for (std::uint32_t i = 10; i > reached.id.index; --i) {
      expected = expected * planar(experience.chain[i - 1].a_from_b).inverse();
    }
    EXPECT_EQ(reached.depth, reached.id.index > 10 ? reached.id.index - 10 : 10 - reached.id.index);
    const Pose2 found = planar(reached.centre_from_place);
    EXPECT_LT((found.translation() - expected.translation()).norm(), 1e-9);
    EXPECT_NEAR(wrap_angle(found.heading - expected.heading), 0.0, 1e-9);
  }
}

TEST(BreadthFirst, IsTheSameInTheWindowOfEverything) {
  Random random(43);
  for (int round = 0; round < 10; ++round) {
    const Snapshot snapshot = make_network(random, 3, 3, 4, 3);
    const Window window = make_window(snapshot, {std::nullopt, 0, 1000, {}});
    const PlaceId centre = pick_place(random, snapshot);
    const auto one = breadth_first(snapshot, centre, 6, 40);
    const auto two = breadth_first(window, centre, 6, 40);
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(one[i].id, two[i].id);
      EXPECT_EQ(planar(one[i].centre_from_place), planar(two[i].centre_from_place));
    }
  }
}

TEST(BreadthFirst, KeepsTheKindOfItsRelations) {
  Random random(44);
  const BatchPlan plan{ExperienceId{5}, support::random_id<RobotId>(random), 1, 5, 0, "along"};
  Batch batch = support::make_batch(random, Snapshot{}, plan);
  for (Edge& edge : batch.edges) edge.a_from_b = AlongPath{1.0, 0.01, 0.0, 0.01};
  const auto reached = breadth_first(with(Snapshot{}, batch), {plan.experience, 0}, 9, 9);
  ASSERT_EQ(reached.size(), 5U);
  EXPECT_DOUBLE_EQ(std::get<AlongPath>(reached[4].centre_from_place).distance_m, 4.0);
}

TEST(BreadthFirst, HasNothingWhereNothingIs) {
  Random random(45);
  const Snapshot snapshot = make_network(random);
  EXPECT_TRUE(breadth_first(snapshot, {ExperienceId{2}, 0}, 5, 5).empty());
  EXPECT_TRUE(breadth_first(snapshot, pick_place(random, snapshot), 5, 0).empty());
  EXPECT_EQ(breadth_first(snapshot, pick_place(random, snapshot), 0, 5).size(), 1U);
}

/// Cost of the cheapest drivable way between all pairs (Floyd & Warshall).
std::map<std::pair<PlaceId, PlaceId>, double> all_pairs(const Snapshot& snapshot,
                                                        const std::set<std::string>& methods) {
  const std::vector<PlaceId> ids = all_places(snapshot);
  std::map<std::pair<PlaceId, PlaceId>, double> cost;
  for (const PlaceId& a : ids) {
    for (const PlaceId& b : ids) cost[{a, b}] = a == b ? 0.0 : std::numeric_limits<double>::infinity();
    snapshot.for_each_edge(a, [&](const Edge& edge) {
      if (!can_drive(edge, a) || !methods.contains(edge.method)) return;
      double& known = cost[{a, other_end(edge, a)}];
      known = std::min(known, norm(edge.a_from_b));
    });
  }
  for (const PlaceId& via : ids) {
    for (const PlaceId& a : ids) {
      for (const PlaceId& b : ids) cost[{a, b}] = std::min(cost[{a, b}], cost[{a, via}] + cost[{via, b}]);
    }
  }
  return cost;
}

TEST(ShortestPath, IsNeverLongerThanBruteForceAndAlwaysDrivable) {
  Random random(46);
  int found = 0;
  int none = 0;
  for (int round = 0; round < 15; ++round) {
    Snapshot snapshot = make_network(random, 3, 2, 4, 3);
    const BatchPlan other{ExperienceId{9}, support::random_id<RobotId>(random), 1, 4, 4, "floor"};
    snapshot = with(snapshot, support::make_batch(random, snapshot, other));
    const std::set<std::string> methods =
        random.chance(0.5) ? std::set<std::string>{"marks"} : std::set<std::string>{"floor", "marks"};
    const auto cost = all_pairs(snapshot, methods);
    for (const PlaceId& from : all_places(snapshot)) {
      for (const PlaceId& to : all_places(snapshot)) {
        const Result<Path> path = shortest_path(snapshot, from, to, methods);
        ASSERT_EQ(path.has_value(), std::isfinite(cost.at({from, to})));
        if (!path) {
          ++none;
          continue;
        }
        ++found;
        ASSERT_EQ(path->places.front(), from);
        ASSERT_EQ(path->places.back(), to);
        ASSERT_EQ(path->relations.size() + 1, path->places.size());
        double sum = 0.0;
        for (std::size_t i = 0; i < path->relations.size(); ++i) {
          sum += norm(path->relations[i]);
          bool drivable = false;
          snapshot.for_each_edge(path->places[i], [&](const Edge& edge) {
            drivable = drivable || (other_end(edge, path->places[i]) == path->places[i + 1] &&
                                    can_drive(edge, path->places[i]) && methods.contains(edge.method));
          });
          EXPECT_TRUE(drivable);
        }
        EXPECT_NEAR(sum, cost.at({from, to}), 1e-9);
      }
    }
  }
  EXPECT_GT(found, 1000);
  EXPECT_GT(none, 100);
}

TEST(ShortestPath, FollowsOdometryForwardsOnly) {
  Random random(47);
  const BatchPlan plan{ExperienceId{5}, support::random_id<RobotId>(random), 1, 6, 0, "marks"};
  const Snapshot snapshot = with(Snapshot{}, support::make_batch(random, Snapshot{}, plan));
  const PlaceId first{plan.experience, 1};
  const PlaceId last{plan.experience, 4};
  const Result<Path> there = shortest_path(snapshot, first, last, {"marks"});
  ASSERT_TRUE(there);
  EXPECT_EQ(there->places.size(), 4U);
  double length = 0.0;
  for (std::size_t i = 1; i < 4; ++i) length += distance_m(snapshot.experience(plan.experience)->chain[i].a_from_b);
  EXPECT_NEAR(there->length_m, length, 1e-12);
  const Result<Path> back = shortest_path(snapshot, last, first, {"marks"});
  ASSERT_FALSE(back);
  EXPECT_EQ(back.error().code, ErrorCode::not_found);
  EXPECT_THAT(back.error().message, HasSubstr("2 places can be reached, the farthest is 0000000000000005:5"));
  EXPECT_THAT(shortest_path(snapshot, first, last, {"floor"}).error().message, HasSubstr("methods: floor"));
}

TEST(ShortestPath, ToWhereOneIsHasNoLength) {
  Random random(48);
  const Snapshot snapshot = make_network(random);
  const PlaceId here = pick_place(random, snapshot);
  const Result<Path> path = shortest_path(snapshot, here, here, {});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->places, std::vector<PlaceId>{here});
  EXPECT_TRUE(path->relations.empty());
  EXPECT_DOUBLE_EQ(path->length_m, 0.0);
  EXPECT_EQ(shortest_path(snapshot, here, {ExperienceId{2}, 0}, {}).error().code, ErrorCode::not_found);
}

TEST(ShortestPath, BreaksTiesByPlaceId) {
  // Two ways of equal length from 100:0 to 400:0, over 200:0 or over 300:0.
  Random random(49);
  Snapshot snapshot;
  for (const std::uint64_t id : {100U, 200U, 300U, 400U}) {
    Batch batch = support::make_batch(random, snapshot,
                                      {ExperienceId{id}, support::random_id<RobotId>(random), 1, 1, 0, "marks"});
    const auto join = [&](std::uint64_t a) {
      Edge edge = support::make_stitch(random, {ExperienceId{a}, 0}, {ExperienceId{id}, 0}, "marks");
      edge.drivable = Drivable::both;
      edge.a_from_b = Metric2{{1.0, 0.0, 0.0}, Eigen::Matrix3d::Zero()};
      batch.edges.push_back(edge);
    };
    if (id == 200 || id == 300) join(100);
    if (id == 400) {
      join(300);
      join(200);
    }
    snapshot = with(snapshot, batch);
  }
  const Result<Path> path = shortest_path(snapshot, {ExperienceId{100}, 0}, {ExperienceId{400}, 0}, {"marks"});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->places[1].experience, ExperienceId{200});
}

TEST(Edge, IsDrivenFromEitherEndAsItSays) {
  Edge edge;
  edge.id = {{ExperienceId{1}, 0}, {ExperienceId{2}, 0}};
  edge.a_from_b = Metric2{{1.0, 2.0, 0.5}, Eigen::Matrix3d::Zero()};
  const auto [a, b] = edge.id;
  for (const Drivable drivable : {Drivable::none, Drivable::a_to_b, Drivable::b_to_a, Drivable::both}) {
    edge.drivable = drivable;
    EXPECT_EQ(can_drive(edge, a), drivable == Drivable::a_to_b || drivable == Drivable::both);
    EXPECT_EQ(can_drive(edge, b), drivable == Drivable::b_to_a || drivable == Drivable::both);
    EXPECT_FALSE(can_drive(edge, PlaceId{}));
  }
  EXPECT_EQ(planar(relation_from(edge, a)), planar(edge.a_from_b));
  EXPECT_EQ(planar(relation_from(edge, b)), planar(edge.a_from_b).inverse());
  EXPECT_EQ(other_end(edge, a), b);
  EXPECT_EQ(other_end(edge, b), a);
}

}  // namespace
}  // namespace weft
