#include "core/network/codec.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/network_maker.hpp"

namespace weft {
namespace {

using support::random_id;

Goal random_goal(Random& random) {
  Goal goal;
  goal.id = random_id<GoalId>(random);
  goal.label = "dock";
  goal.to = {ExperienceId{random.next()}, 7};
  if (random.chance(0.5)) goal.wanted = random_id<RobotId>(random);
  if (random.chance(0.5)) goal.robot = random_id<RobotId>(random);
  goal.state = static_cast<GoalState>(1 + random.below(8));
  goal.number = random.below(1000);
  if (random.chance(0.5)) goal.route = random_id<RouteId>(random);
  goal.route_version = 3;
  goal.priority = static_cast<std::uint8_t>(random.below(10));
  goal.kind = static_cast<GoalKind>(1 + random.below(4));
  goal.no_return = random.chance(0.5);
  for (std::uint64_t i = random.below(4); i > 0; --i) {
    goal.history.push_back({WallTime(Duration(static_cast<std::int64_t>(random.next()))),
                            static_cast<GoalState>(1 + random.below(8)), "cause", "who"});
  }
  return goal;
}

Route random_route(Random& random) {
  Route route;
  route.goal = random_id<GoalId>(random);
  route.id = random_id<RouteId>(random);
  route.robot = random_id<RobotId>(random);
  route.made_of = {random.below(100)};
  const std::uint64_t places = random.below(5);
  for (std::uint64_t i = 0; i < places; ++i) {
    route.places.push_back({ExperienceId{random.next()}, static_cast<std::uint32_t>(i)});
    if (i > 0) route.relations.push_back(support::random_relation(random));
  }
  route.released = places == 0 ? 0 : static_cast<std::uint32_t>(random.below(places));
  if (places > 1) route.limits = {{0, 1, 0.5}, {1, 1, 0.25}};
  route.ended = random.chance(0.5);
  route.reason = "waits";
  return route;
}

Batch random_batch(Random& random) {
  const Snapshot snapshot = support::make_network(random, 2, 1, 3, 1);
  Batch batch =
      support::make_batch(random, snapshot, {ExperienceId{9}, random_id<RobotId>(random), 1, 3, 2, "marks"});
  for (Edge& edge : batch.edges) edge.a_from_b = support::random_relation(random);
  batch.seal = random.chance(0.5);
  batch.seal_reason = "done";
  return batch;
}

/// Expects that a value comes back as it went in; and whatever happens to the bytes, that they are either read as
/// what encodes to just these bytes or refused as corrupt.
template <class T, class Decode>
void expect_round_trip(const T& value, Decode&& decode) {
  const Bytes bytes = encode(value);
  const auto back = decode(ByteView(bytes));
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_EQ(encode(*back), bytes);

  const auto expect_sound = [&](const Bytes& damaged) {
    const auto read = decode(ByteView(damaged));
    if (read) {
      EXPECT_EQ(encode(*read), damaged);
    } else {
      EXPECT_EQ(read.error().code, ErrorCode::corrupt);
      EXPECT_FALSE(read.error().message.empty());
    }
    return read.has_value();
  };
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(expect_sound(Bytes(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size))));
  }
  Bytes longer = bytes;
  longer.push_back(0);
  EXPECT_FALSE(expect_sound(longer));
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    for (const unsigned flip : {0x01U, 0x80U, 0xffU}) {
      Bytes damaged = bytes;
      damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ flip);
      expect_sound(damaged);
    }
  }
}

TEST(Codec, RelationsComeBackAndDamageIsSeen) {
  Random random(1);
  for (int i = 0; i < 6; ++i) {
    expect_round_trip(Relation(support::random_metric2(random)), decode_relation);
    expect_round_trip(Relation(support::random_metric3(random)), decode_relation);
    expect_round_trip(Relation(support::random_along_path(random)), decode_relation);
  }
}

TEST(Codec, PlacesAndEdgesComeBackAndDamageIsSeen) {
  Random random(2);
  const support::BatchPlan plan{ExperienceId{5}, random_id<RobotId>(random), 1, 1, 0, "floor"};
  expect_round_trip(support::make_place(random, plan, 12), decode_place);
  expect_round_trip(support::make_stitch(random, {ExperienceId{1}, 3}, {ExperienceId{5}, 4}, "floor"), decode_edge);
  EXPECT_EQ(decode_place(encode(support::make_place(random, plan, 3)))->id, (PlaceId{ExperienceId{5}, 3}));
}

TEST(Codec, BatchesGoalsAndRoutesComeBackAndDamageIsSeen) {
  Random random(3);
  expect_round_trip(random_batch(random), decode_batch);
  for (int i = 0; i < 8; ++i) {
    expect_round_trip(random_goal(random), decode_goal);
    expect_round_trip(random_route(random), decode_route);
  }
}

TEST(Codec, SpeedLimitsAreHeldToTheirRoute) {
  Random random(6);
  Route route = random_route(random);
  while (route.places.size() < 3) route = random_route(random);
  const auto refused = [&](const SpeedLimit& limit) {
    route.limits = {{1, 1, 0.5}, limit};
    const auto read = decode_route(encode(route));
    return !read && read.error().message.find("limit") != std::string::npos;
  };
  EXPECT_FALSE(refused({1, 2, 10.0}));
  EXPECT_TRUE(refused({1, static_cast<std::uint32_t>(route.places.size()), 0.5}));
  EXPECT_TRUE(refused({2, 1, 0.5}));
  EXPECT_TRUE(refused({0, 1, 0.5}));
  EXPECT_TRUE(refused({1, 2, 0.0}));
  EXPECT_TRUE(refused({1, 2, 10.5}));
  EXPECT_TRUE(refused({1, 2, std::nan("")}));
}

TEST(Codec, ACountThatTheBytesCannotHoldIsRefusedBeforeMemoryIsTaken) {
  Random random(4);
  Batch batch = random_batch(random);
  batch.places.clear();
  batch.edges.clear();
  Bytes bytes = encode(batch);
  const std::size_t places_at = 1 + 8 + 8 + 16 + 4 + batch.name.size() + 4 + batch.method.size();
  for (std::size_t i = 0; i < 4; ++i) bytes[places_at + i] = 0xff;
  const auto read = decode_batch(bytes);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::corrupt);
  EXPECT_NE(read.error().message.find("places"), std::string::npos);
}

TEST(Codec, TheBytesAreThoseOfTheDocument) {
  EXPECT_EQ(to_string(hash_bytes({})), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  const Bytes path = encode(Relation(AlongPath{1.0, 0.0, 0.0, 0.0}));
  const Bytes expected{1, 3, 0, 0, 0, 0, 0, 0, 0xf0, 0x3f, 0, 0, 0, 0, 0, 0, 0,
                       0, 0, 0, 0, 0, 0, 0, 0, 0,    0,    0, 0, 0, 0, 0, 0, 0};
  EXPECT_EQ(path, expected);
}

TEST(Codec, ABatchsHashChangesWithIt) {
  Random random(5);
  Batch batch = random_batch(random);
  const ContentHash before = hash(batch);
  EXPECT_EQ(hash(batch), before);
  batch.places.back().frame += 1;
  EXPECT_NE(hash(batch), before);
}

}  // namespace
}  // namespace weft
