#include "tests/core/routing/laws.hpp"
#include "tests/support/site_network.hpp"

namespace weft::routing {
namespace {

TEST(ChangedRoutes, FollowBatchesOneByOne) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Random random(seed);
    Snapshot snapshot = support::make_network(random, 4, 10, 20, 6);
    Preparation preparation = prepare(snapshot, {"marks"});
    support::BatchPlan plan{{random.next() | 1U}, support::random_id<RobotId>(random), 0, 25, 8, "marks"};
    for (int turn = 0; turn < 20; ++turn) {
      ++plan.sequence;
      snapshot = with(snapshot, support::make_batch(random, snapshot, plan));
      preparation = update(preparation, snapshot);
      expect_as_dijkstra(random, preparation, snapshot, 12);
    }
    const Preparation fresh = prepare(snapshot, {"marks"});
    EXPECT_GT(expect_as_dijkstra(random, fresh, snapshot, 30), 5U);
  }
}

TEST(ChangedRoutes, GrowFromNothing) {
  Snapshot snapshot;
  Preparation preparation = prepare(snapshot, {"floor"});
  SiteGenerator generator({.places = 8'000, .seed = 5, .batch_places = 200});
  Random random(3);
  while (!generator.is_done()) {
    snapshot = with(snapshot, generator.next());
    preparation = update(preparation, snapshot);
    expect_as_dijkstra(random, preparation, snapshot, 2);
  }
  EXPECT_GT(expect_as_dijkstra(random, preparation, snapshot, 40), 10U);
}

/// Experiences come and go, as with a rollback and back again.
TEST(ChangedRoutes, FollowRevisionsBackAndForth) {
  SiteGenerator generator({.places = 6'000, .seed = 9});
  std::vector<Snapshot> revisions{Snapshot{}};
  while (!generator.is_done()) revisions.push_back(with(revisions.back(), generator.next()));
  Random random(1);
  Preparation preparation = prepare(revisions.back(), {"floor"});
  for (int turn = 0; turn < 12; ++turn) {
    const Snapshot& snapshot = revisions[1 + random.below(revisions.size() - 1)];
    preparation = update(preparation, snapshot);
    expect_as_dijkstra(random, preparation, snapshot, 10);
  }
}

TEST(ChangedRoutes, ShareWhatDidNotChange) {
  const Snapshot snapshot = support::make_site({.places = 30'000, .seed = 4});
  const Preparation preparation = prepare(snapshot, {"floor"});
  Random random(6);
  const PlaceId place = support::pick_place(random, snapshot);
  const Snapshot labelled = with_label(snapshot, "here", place);
  const Preparation same = update(preparation, labelled);
  EXPECT_EQ(same.base, preparation.base);  // pointers
  EXPECT_EQ(same.overlays, preparation.overlays);

  Batch batch;
  batch.experience = {77};
  batch.sequence = 1;
  batch.method = "floor";
  const support::BatchPlan plan{{77}, support::random_id<RobotId>(random), 1, 1, 0, "floor"};
  batch.robot = plan.robot;
  batch.places.push_back(support::make_place(random, plan, 0));
  batch.edges.push_back(support::make_stitch(random, place, {{77}, 0}, "floor"));
  batch.edges.back().drivable = Drivable::both;
  const Snapshot grown = with(labelled, batch);
  const Preparation next = update(same, grown);
  std::size_t changed = 0;
  for (std::size_t cell = 0; cell < preparation.base.size(); ++cell) {
    changed += next.base[cell] == preparation.base[cell] ? 0U : 1U;
  }
  EXPECT_EQ(changed, 1U);
  EXPECT_TRUE(shortest_path(next, grown, place, {{77}, 0}, {"floor"}));
}

}  // namespace
}  // namespace weft::routing
