#include "core/network/removal.hpp"
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

/// Lets experiences come and go, as with a rollback and back again.
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

/// Picks some places in a row, and a stitch elsewhere.
Removal something(Random& random, const Snapshot& snapshot) {
  const PlaceId first = support::pick_place(random, snapshot);
  Removal removal{{{first.experience, first.index, first.index + static_cast<std::uint32_t>(random.below(30))}}, {}};
  const auto& stitches = snapshot.experience(support::pick_place(random, snapshot).experience)->stitches;
  if (!stitches.empty()) removal.stitches.push_back(stitches[random.below(stitches.size())].id);
  return removal;
}

/// Lets places and stitches vanish, one removal after the other, and come back, all at once.
TEST(ChangedRoutes, FollowRemovalsAndReturns) {
  const Snapshot whole = support::make_site({.places = 5'000, .seed = 12});
  const Preparation prepared = prepare(whole, {"floor"});
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Random random(seed);
    Snapshot snapshot = whole;
    Preparation preparation = prepared;
    for (int turn = 0; turn < 15; ++turn) {
      snapshot = without(snapshot, something(random, snapshot));
      preparation = update(preparation, snapshot);
      expect_as_dijkstra(random, preparation, snapshot, 8);
    }
    EXPECT_LT(snapshot.place_count(), whole.place_count());
    const Snapshot back({snapshot.revision().value + 1}, whole.experiences(), whole.shared_labels());
    preparation = update(preparation, back);
    EXPECT_GT(expect_as_dijkstra(random, preparation, back, 30), 10U);
  }
}

/// Tests what a rollback leads to: the same rows, read from the store again, and some are gone.
TEST(ChangedRoutes, FollowANetworkThatSharesNothing) {
  const SitePlan plan{.places = 5'000, .seed = 13};
  const Preparation preparation = prepare(support::make_site(plan), {"floor"});
  Random random(4);
  Snapshot again = support::make_site(plan);
  for (int turn = 0; turn < 5; ++turn) again = without(again, something(random, again));
  EXPECT_GT(expect_as_dijkstra(random, update(preparation, again), again, 30), 10U);
}

/// Keeps the places; what was joined is joined otherwise.
TEST(ChangedRoutes, FollowAStitchThatChangesItsRelation) {
  Random random(8);
  Snapshot snapshot = support::make_site({.places = 4'000, .seed = 14});
  const Preparation preparation = prepare(snapshot, {"floor"});
  Snapshot::Experiences changed;
  for (const auto& [id, experience] : snapshot.experiences()) {
    auto copy = std::make_shared<Experience>(*experience);
    copy->stitches = {};
    for (Edge stitch : experience->stitches) {
      auto& along = std::get<Metric2>(stitch.a_from_b).a_from_b.x;
      along += 0.25 * static_cast<double>(stitch.id.b.index % 8);
      copy->stitches.push_back(std::make_shared<const Edge>(stitch));
    }
    index_stitches(*copy);
    changed.emplace(id, copy);
  }
  snapshot = {{snapshot.revision().value + 1}, changed, snapshot.shared_labels()};
  EXPECT_GT(expect_as_dijkstra(random, update(preparation, snapshot), snapshot, 30), 10U);
}

TEST(ChangedRoutes, ComeInSmallSteps) {
  Random random(2);
  const Snapshot whole = support::make_site({.places = 5'000, .seed = 15});
  Builder preparing = Builder::to_prepare(whole, {"floor"});
  int steps = 0;
  double share = 0.0;
  while (preparing.step(200)) {
    EXPECT_GE(preparing.share_done(), 0.0);
    EXPECT_LE(preparing.share_done(), 1.0);
    share = std::max(share, preparing.share_done());
    ++steps;
  }
  EXPECT_GT(steps, 20);
  EXPECT_GT(share, 0.7);
  const Preparation preparation = preparing.take();
  EXPECT_GT(expect_as_dijkstra(random, preparation, whole, 10), 3U);

  const Snapshot thinned = without(whole, something(random, whole));
  Builder updating = Builder::to_update(preparation, thinned);
  while (updating.step(1)) {
  }
  EXPECT_GT(expect_as_dijkstra(random, updating.take(), thinned, 10), 3U);
  Result<Builder> resuming = Builder::to_resume(encode(preparation), thinned);
  ASSERT_TRUE(resuming) << resuming.error().message;
  while (resuming->step(1)) {
  }
  EXPECT_GT(expect_as_dijkstra(random, resuming->take(), thinned, 10), 3U);
}

TEST(ChangedRoutes, SayWithoutWordsThatThereIsNoWay) {
  Random random(9);
  const Snapshot snapshot = support::make_network(random, 2, 2, 5, 0);
  const Preparation preparation = prepare(snapshot, {"marks"});
  const PlaceId first{snapshot.experiences().begin()->first, 0};
  const PlaceId other{snapshot.experiences().rbegin()->first, 0};
  const Result<std::optional<Path>> none = find_path(preparation, snapshot, first, other, {"marks"});
  ASSERT_TRUE(none) << none.error().message;
  EXPECT_FALSE(*none);
  const Result<std::optional<Path>> nowhere = find_path(preparation, snapshot, first, {{1}, 5}, {"marks"});
  ASSERT_TRUE(nowhere);
  EXPECT_FALSE(*nowhere);
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
