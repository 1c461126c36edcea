#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "clients/evaluate/generate/site_generator.hpp"
#include "core/network/prune.hpp"
#include "core/network/search.hpp"
#include "tests/support/network_maker.hpp"

namespace weft {
namespace {

constexpr std::uint64_t kOld = 1;
constexpr std::uint64_t kNew = 2;

PlaceId at(std::uint64_t experience, std::uint32_t index) {
  return {{experience}, index};
}

/// Describes two runs along one straight lane, half a metre a place; the newer one lies `aside_m` to the left, or
/// comes the other way, and is stitched to the older one at every `every`-th place.
struct Lane {
  std::uint32_t places = 12;
  double aside_m = 0.1;
  bool opposite = false;
  std::uint32_t every = 3;

  Snapshot drive() const {
    Random random(5);
    Snapshot snapshot;
    for (const std::uint64_t run : {kOld, kNew}) {
      Batch batch;
      batch.experience = {run};
      batch.sequence = 1;
      batch.robot = support::random_id<RobotId>(random);
      batch.name = run == kOld ? "old" : "new";
      batch.method = "marks";
      for (std::uint32_t index = 0; index < places; ++index) {
        batch.places.push_back(support::make_place(random, {.experience = {run}, .robot = batch.robot}, index));
        if (index == 0) continue;
        Edge step;
        step.id = {at(run, index - 1), at(run, index)};
        step.a_from_b = Metric2{{0.5, 0.0, 0.0}, Eigen::Matrix3d::Identity() * 1e-6};
        step.method = "marks";
        batch.edges.push_back(step);
      }
      for (std::uint32_t index = 0; run == kNew && index < places; index += every) {
        Edge stitch;
        const std::uint32_t beside = opposite ? places - 1 - index : index;
        stitch.id = {at(kOld, beside), at(kNew, index)};
        stitch.a_from_b = Metric2{{0.0, aside_m, opposite ? 3.14159 : 0.0}, Eigen::Matrix3d::Identity() * 1e-6};
        stitch.origin = Origin::stitch;
        stitch.method = "marks";
        stitch.drivable = opposite ? Drivable::none : Drivable::both;
        batch.edges.push_back(stitch);
      }
      EXPECT_TRUE(check(snapshot, batch).empty());
      snapshot = with(snapshot, batch);
    }
    return snapshot;
  }
};

Removal prune(const Snapshot& snapshot, PruneRule rule = {}) {
  Pruner pruner(snapshot, std::move(rule));
  while (pruner.step()) {
  }
  EXPECT_EQ(pruner.done(), pruner.total());
  return pruner.found();
}

PruneRule by(std::uint64_t experience) {
  PruneRule rule;
  rule.by = ExperienceId{experience};
  return rule;
}

bool goes(const Removal& removal, const PlaceId& place) {
  return std::any_of(removal.places.begin(), removal.places.end(), [&](const Stretch& run) {
    return run.experience == place.experience && run.first <= place.index && place.index <= run.last;
  });
}

TEST(Prune, WhatANewRunCoversGoes) {
  const Removal gone = prune(Lane{}.drive(), by(kNew));
  EXPECT_EQ(gone.places, (std::vector<Stretch>{{{kOld}, 0, 11}}));
}

TEST(Prune, EitherRunButNeverBoth) {
  const Removal gone = prune(Lane{}.drive());
  EXPECT_GT(place_count(gone), 0U);
  for (std::uint32_t index = 0; index < 12; ++index) {
    EXPECT_FALSE(goes(gone, at(kOld, index)) && goes(gone, at(kNew, index))) << "nobody covers place " << index;
  }
}

TEST(Prune, LabelledPlacesAndThoseInUseStay) {
  const Snapshot labelled = with_label(Lane{}.drive(), "dock", at(kOld, 5));
  PruneRule rule = by(kNew);
  rule.keep = {at(kOld, 8)};
  const Removal gone = prune(labelled, rule);
  EXPECT_FALSE(goes(gone, at(kOld, 5)));
  EXPECT_FALSE(goes(gone, at(kOld, 8)));
  EXPECT_TRUE(goes(gone, at(kOld, 1)) && goes(gone, at(kOld, 10))) << "the rest can go";
  const Snapshot left = without(labelled, gone);
  EXPECT_TRUE(shortest_path(left, at(kNew, 0), at(kOld, 5), {"marks"})) << "the label can still be driven to";
}

TEST(Prune, TooFarAsideOrTheOtherWayRoundCoversNothing) {
  EXPECT_TRUE(prune(Lane{.aside_m = 0.8}.drive(), by(kNew)).empty());
  EXPECT_TRUE(prune(Lane{.opposite = true}.drive(), by(kNew)).empty());
}

TEST(Prune, AWayThatOnlyTheOldRunHasStays) {
  Lane lane;
  Snapshot snapshot = lane.drive();
  // The newer run has lost its middle: only the older one leads through there.
  snapshot = without(snapshot, {{{{kNew}, 5, 6}}, {}});
  const Removal gone = prune(snapshot, by(kNew));
  const Snapshot left = without(snapshot, gone);
  EXPECT_TRUE(shortest_path(left, at(kNew, 0), at(kNew, 11), {"marks"}));
  EXPECT_FALSE(goes(gone, at(kOld, 5)));
}

TEST(Prune, WhatWasJoinedMeanwhileStays) {
  const Snapshot before = Lane{}.drive();
  Pruner pruner(before, by(kNew));
  while (pruner.step()) {
  }
  Random random(9);
  Batch more = support::make_batch(random, before, {.experience = {3}, .robot = support::random_id<RobotId>(random)});
  std::erase_if(more.edges, [](const Edge& edge) { return edge.origin == Origin::stitch; });
  more.edges.push_back(support::make_stitch(random, at(kOld, 4), more.places.front().id, "marks"));
  const Snapshot after = with(before, more);
  EXPECT_TRUE(only_grew(before, after));
  EXPECT_TRUE(still_unneeded(pruner, after, {}).empty()) << "the run that place 4 is in is joined to another now";
  EXPECT_FALSE(still_unneeded(pruner, before, {}).empty());
  EXPECT_FALSE(only_grew(after, before));
}

// Whatever goes, whoever stays can be reached as before.
TEST(Prune, StationsOfASiteStayReachable) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    SitePlan plan;
    plan.places = 8000;
    plan.seed = seed;
    plan.batch_places = 500;
    SiteGenerator generator(plan);
    Snapshot snapshot;
    while (!generator.is_done()) snapshot = with(snapshot, generator.next());
    for (const auto& [label, place] : generator.labels()) snapshot = with_label(snapshot, label, place);
    const Removal gone = prune(snapshot);
    EXPECT_GT(place_count(gone), 0U) << "seed " << seed;
    const Snapshot left = without(snapshot, gone);
    EXPECT_EQ(left.labels(), snapshot.labels());
    const std::set<std::string> methods = {snapshot.experiences().begin()->second->method};
    for (const auto& [from, first] : snapshot.labels()) {
      for (const auto& [to, last] : snapshot.labels()) {
        if (!shortest_path(snapshot, first, last, methods)) continue;
        EXPECT_TRUE(shortest_path(left, first, last, methods)) << "seed " << seed << ": " << from << " to " << to;
      }
    }
  }
}

}  // namespace
}  // namespace weft
