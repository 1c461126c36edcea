#include "server/routes/routes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

#include "core/network/removal.hpp"
#include "storage/memory/memory_store.hpp"
#include "tests/core/routing/laws.hpp"
#include "tests/support/site_network.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::set<std::string> kFloor{"floor"};

/// Serves routes over a network that the test changes, with both clocks in its hand.
struct Rig {
  explicit Rig(Snapshot snapshot, std::shared_ptr<storage::MemoryDisk> on = std::make_shared<storage::MemoryDisk>())
      : disk(std::move(on)), store(storage::make_memory_store(disk)), snapshots(std::move(snapshot)) {
    EXPECT_TRUE(store->open());
  }

  /// Works until nothing is left to be done. Returns how many pieces that took.
  int settle() {
    int pieces = 0;
    for (; routes.next(); ++pieces) {
      if (pieces == 100'000) throw std::runtime_error("there is no end to it");
      now.steady = std::max(now.steady, *routes.next());
      routes.tick(now);
    }
    return pieces;
  }
  const Snapshot& network() const { return snapshots.current(); }
  Result<Path> find(const PlaceId& from, const PlaceId& to) { return routes.find(from, to, kFloor, now.steady); }
  void expect_as_dijkstra(Random& random, int pairs) {
    for (int i = 0; i < pairs; ++i) {
      const PlaceId from = support::pick_place(random, network());
      const PlaceId to = support::pick_place(random, network());
      const Result<Path> wanted = shortest_path(network(), from, to, kFloor);
      const Result<Path> got = find(from, to);
      ASSERT_EQ(wanted.has_value(), got.has_value()) << to_string(from) << " to " << to_string(to);
      if (!wanted) continue;
      EXPECT_NEAR(routing::cost(*wanted), routing::cost(*got), 1e-9 * (1.0 + routing::cost(*wanted)));
      routing::expect_drivable(network(), *got, kFloor);
    }
  }

  std::shared_ptr<storage::MemoryDisk> disk;
  std::unique_ptr<storage::MapStore> store;
  ServiceConfig config;
  Outbox out{{}, 1, Epoch{1}};
  Counters counters;
  MapWriter writer{*store, Snapshot{}, out, counters};
  Maintenance maintenance{*store};
  Snapshots snapshots;  ///< the test's own: its networks are nobody's batches
  Context context{config, *store, out, counters, writer, snapshots, maintenance};
  Routes routes{context};
  Now now{.steady = SteadyTime(1000s), .wall = WallTime(5000s)};
};

TEST(Routes, AreDijkstrasUntilTheNetworkIsPreparedPieceByPiece) {
  Rig rig(support::make_site({.places = 20'000, .seed = 1}));
  Random random(1);
  EXPECT_FALSE(rig.routes.next()) << "nobody drives";
  rig.expect_as_dijkstra(random, 3);
  rig.routes.want(kFloor);
  rig.routes.tick(rig.now);
  EXPECT_FALSE(rig.routes.is_prepared(kFloor));
  rig.expect_as_dijkstra(random, 3);
  EXPECT_GT(rig.settle(), 5) << "messages come in between";
  EXPECT_TRUE(rig.routes.is_prepared(kFloor));
  rig.expect_as_dijkstra(random, 10);
}

TEST(Routes, FollowTheNetworkWhetherTheyAreAskedBeforeOrAfterItIsPreparedAgain) {
  Rig rig(support::make_site({.places = 4'000, .seed = 2}));
  Random random(2);
  rig.routes.want(kFloor);
  rig.settle();
  const Snapshot whole = rig.network();
  for (int turn = 0; turn < 6; ++turn) {
    const PlaceId first = support::pick_place(random, rig.network());
    rig.snapshots.push(without(rig.network(), {{{first.experience, first.index, first.index + 40}}, {}}));
    if (turn % 2 == 0) rig.settle();
    rig.expect_as_dijkstra(random, 5);
  }
  rig.snapshots.push({{rig.network().revision().value + 1}, whole.experiences(), whole.shared_labels()});
  rig.expect_as_dijkstra(random, 5);
  rig.settle();
  rig.expect_as_dijkstra(random, 5);
}

TEST(Routes, KeepUpWithChangesThatComeWhileTheyWork) {
  SiteGenerator generator({.places = 6'000, .seed = 3, .batch_places = 100});
  Rig rig{Snapshot()};
  Random random(3);
  rig.routes.want(kFloor);
  while (!generator.is_done()) {
    rig.snapshots.push(with(rig.network(), generator.next()));
    rig.now.steady += 50ms;
    rig.routes.tick(rig.now);
    rig.expect_as_dijkstra(random, 1);
  }
  rig.settle();
  rig.expect_as_dijkstra(random, 10);
}

TEST(Routes, ArePreparedAnewWhenTheNetworkHasOutgrownThem) {
  Rig rig{Snapshot()};
  rig.routes.want(kFloor);
  rig.settle();
  SiteGenerator generator({.places = 4'000, .seed = 4, .batch_places = 500});
  while (!generator.is_done()) {
    rig.snapshots.push(with(rig.network(), generator.next()));
    rig.settle();
  }
  rig.now.steady += 31min;
  rig.snapshots.push(with_label(rig.network(), "here", generator.labels().begin()->second));
  rig.settle();  // and is stored
  const auto stored = routing::decode(rig.store->preparation("floor").value(), rig.network());
  ASSERT_TRUE(stored);
  EXPECT_GT(stored->base.size(), 4'000U / 192U);
}

TEST(Routes, GoOnAfterARestartWithWhatIsStored) {
  const Snapshot site = support::make_site({.places = 20'000, .seed = 5});
  Rig first(site);
  first.routes.want(kFloor);
  const int anew = first.settle();
  Random random(5);
  const PlaceId gone = support::pick_place(random, site);
  Rig second(without(site, {{{gone.experience, gone.index, gone.index + 20}}, {}}), first.disk);
  second.routes.want(kFloor);
  EXPECT_LT(second.settle(), anew / 2);
  EXPECT_TRUE(second.routes.is_prepared(kFloor));
  second.expect_as_dijkstra(random, 10);
  EXPECT_TRUE(second.counters.empty());
}

TEST(Routes, ArePreparedAnewWhenWhatIsStoredIsDamaged) {
  const auto disk = std::make_shared<storage::MemoryDisk>();
  const Snapshot site = support::make_site({.places = 2'000, .seed = 6});
  {
    const auto store = storage::make_memory_store(disk);
    ASSERT_TRUE(store->open());
    ASSERT_TRUE(store->commit({{storage::PutPreparation{"floor", Bytes(100, 7)}}}));
  }
  Rig rig(site, disk);
  rig.routes.want(kFloor);
  rig.settle();
  EXPECT_EQ(rig.counters["routes: stored preparation is damaged, made anew"], 1U);
  Random random(6);
  rig.expect_as_dijkstra(random, 5);
}

TEST(Routes, OfOtherMethodsUnderThisNameAreNotTaken) {
  const auto disk = std::make_shared<storage::MemoryDisk>();
  const Snapshot site = support::make_site({.places = 2'000, .seed = 7});
  {
    const auto store = storage::make_memory_store(disk);
    ASSERT_TRUE(store->open());
    const Bytes others = routing::encode(routing::prepare(site, {"marks"}));
    ASSERT_TRUE(store->commit({{storage::PutPreparation{"floor", others}}}));
  }
  Rig rig(site, disk);
  rig.routes.want(kFloor);
  rig.settle();
  Random random(7);
  rig.expect_as_dijkstra(random, 5);
}

TEST(Routes, SayFromWhereOneGetsNoFartherOnceInAWhile) {
  Random random(8);
  Rig rig(support::make_network(random, 2, 2, 5, 0));
  rig.routes.want({"marks"});
  rig.settle();
  const PlaceId from{rig.network().experiences().begin()->first, 0};
  const PlaceId to{rig.network().experiences().rbegin()->first, 3};
  const auto words = [&] { return rig.routes.find(from, to, {"marks"}, rig.now.steady).error().message; };
  const std::string first = words();
  EXPECT_EQ(first, shortest_path(rig.network(), from, to, {"marks"}).error().message);
  // Another place is named though how far one gets from there is not looked up now.
  const PlaceId other{from.experience, 1};
  EXPECT_THAT(rig.routes.find(other, to, {"marks"}, rig.now.steady).error().message,
              AllOf(HasSubstr("no path from " + to_string(other) + " to "), Not(HasSubstr("can be reached"))));
  // The map grows where it does not help.
  const support::BatchPlan plan{from.experience, rig.network().experience(from.experience)->robot, 3, 4, 0, "marks"};
  rig.snapshots.push(with(rig.network(), support::make_batch(random, rig.network(), plan)));
  EXPECT_EQ(words(), first);
  rig.now.steady += 2min;
  EXPECT_NE(words(), first);
  EXPECT_EQ(words(), shortest_path(rig.network(), from, to, {"marks"}).error().message);
  // A place that is not there is told at once.
  EXPECT_THAT(rig.routes.find({{1}, 1}, to, {"marks"}, rig.now.steady).error().message,
              HasSubstr("is not in the network"));
  // A way that comes is found at once.
  rig.snapshots.push(without(rig.network(), {{{to.experience, 0, 100}}, {}}));
  Batch bridge = support::make_batch(random, rig.network(), {{77}, plan.robot, 1, 1, 0, "marks"});
  bridge.edges.push_back(support::make_stitch(random, from, {{77}, 0}, "marks"));
  bridge.edges.back().drivable = Drivable::both;
  rig.snapshots.push(with(rig.network(), bridge));
  EXPECT_TRUE(rig.routes.find(from, {{77}, 0}, {"marks"}, rig.now.steady));
}

TEST(Routes, ArePreparedForFewSetsOfMethods) {
  Rig rig(support::make_site({.places = 500, .seed = 9}));
  for (const char* more : {"a", "b", "c", "d", "e"}) rig.routes.want({"floor", more});
  rig.routes.want({"floor", "a"});
  rig.routes.want({});
  rig.settle();
  EXPECT_TRUE(rig.routes.is_prepared({"floor", "d"}));
  EXPECT_FALSE(rig.routes.is_prepared({"floor", "e"}));
  EXPECT_EQ(rig.counters["routes: sets of methods that are not prepared"], 1U);
  Random random(9);
  const PlaceId from = support::pick_place(random, rig.network());
  EXPECT_TRUE(rig.routes.find(from, from, {"floor", "e"}, rig.now.steady));
}

}  // namespace
}  // namespace weft::server
