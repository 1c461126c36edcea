#include "tests/core/routing/laws.hpp"
#include "tests/support/site_network.hpp"

namespace weft::routing {
namespace {

TEST(Routes, AreDijkstrasOnRandomNetworks) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    const Snapshot snapshot = support::make_network(random, 6, 8, 12, 5);
    found += expect_as_dijkstra(random, prepare(snapshot, {"marks"}), snapshot, 60);
  }
  EXPECT_GT(found, 200U);
}

TEST(Routes, AreDijkstrasOnASite) {
  Random random(7);
  const Snapshot snapshot = support::make_site({.places = 30'000, .seed = 3});
  const Preparation preparation = prepare(snapshot, {"floor"});
  ASSERT_GT(preparation.overlays[1].size(), 4U);  // cells in cells, or this tests little
  EXPECT_GT(expect_as_dijkstra(random, preparation, snapshot, 150), 100U);
}

TEST(Routes, KeepToTheirMethods) {
  Random random(11);
  Snapshot snapshot;
  for (std::uint64_t i = 1; i <= 6; ++i) {
    const support::BatchPlan plan{{i}, support::random_id<RobotId>(random), 1, 150,
                                  40,  i % 2 == 0 ? "floor" : "marks"};
    snapshot = with(snapshot, support::make_batch(random, snapshot, plan));
  }
  for (const std::set<std::string>& methods :
       {std::set<std::string>{"floor"}, std::set<std::string>{"marks"}, std::set<std::string>{"floor", "marks"}}) {
    expect_as_dijkstra(random, prepare(snapshot, methods), snapshot, 80);
  }
  const Preparation nothing = prepare(snapshot, {});
  EXPECT_EQ(shortest_path(nothing, snapshot, {{1}, 0}, {{1}, 1}, {}).error().code, ErrorCode::not_found);
}

TEST(Routes, FromAPlaceToItselfHaveNoLength) {
  Random random(5);
  const Snapshot snapshot = support::make_network(random);
  const PlaceId place = support::pick_place(random, snapshot);
  const Result<Path> path = shortest_path(prepare(snapshot, {"marks"}), snapshot, place, place, {"marks"});
  ASSERT_TRUE(path);
  EXPECT_EQ(path->places, std::vector<PlaceId>{place});
  EXPECT_EQ(path->length_m, 0.0);
}

TEST(Routes, AreRefusedForAnotherRevisionOrOtherMethods) {
  Random random(5);
  const Snapshot snapshot = support::make_network(random);
  const Preparation preparation = prepare(snapshot, {"marks"});
  const PlaceId place = support::pick_place(random, snapshot);
  const Snapshot later = with_label(snapshot, "elsewhere", place);
  EXPECT_EQ(shortest_path(preparation, later, place, place, {"marks"}).error().code, ErrorCode::stale);
  EXPECT_EQ(shortest_path(preparation, snapshot, place, place, {"floor"}).error().code, ErrorCode::invalid);
}

TEST(Routes, NameAPlaceThatIsNotThere) {
  Random random(5);
  const Snapshot snapshot = support::make_network(random);
  const PlaceId place = support::pick_place(random, snapshot);
  const Result<Path> path = shortest_path(prepare(snapshot, {"marks"}), snapshot, place, {{2}, 77}, {"marks"});
  ASSERT_FALSE(path);
  EXPECT_EQ(path.error().message, weft::shortest_path(snapshot, place, {{2}, 77}, {"marks"}).error().message);
}

TEST(Routes, AreFoundInAnEmptyNetworkByNobody) {
  const Preparation preparation = prepare(Snapshot{}, {"marks"});
  EXPECT_EQ(shortest_path(preparation, Snapshot{}, {{1}, 0}, {{1}, 0}, {"marks"}).error().code, ErrorCode::not_found);
}

TEST(RouteBuilder, GivesTheSameInSmallStepsAndTellsHowFarItIs) {
  const Snapshot snapshot = support::make_site({.places = 4'000, .seed = 2});
  Builder builder = Builder::to_prepare(snapshot, {"floor"});
  std::size_t steps = 0;
  double share = 0.0;
  while (builder.step(100)) {
    ++steps;
    EXPECT_GE(builder.share_done() + 0.02, share);
    share = std::max(share, builder.share_done());
    EXPECT_LE(share, 1.0);
  }
  EXPECT_GT(steps, 100U);
  EXPECT_GT(share, 0.9);
  EXPECT_EQ(encode(builder.take()), encode(prepare(snapshot, {"floor"})));
}

}  // namespace
}  // namespace weft::routing
