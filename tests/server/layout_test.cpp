#include "server/traffic/layout.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/network/removal.hpp"
#include "tests/support/network_maker.hpp"

namespace weft::server::test {
namespace {

using support::BatchPlan;
using support::make_batch;
using support::make_network;
using support::pick_place;
using support::random_id;

constexpr std::size_t kAll = 1'000'000;

Layout::Network share(Snapshot snapshot) {
  return std::make_shared<const Snapshot>(std::move(snapshot));
}

Layout laid_anew(const Layout::Network& network, std::vector<PlaceId> roots = {}) {
  Layout layout(0.0);
  layout.lay(network, std::move(roots));
  layout.work(kAll);
  EXPECT_FALSE(layout.has_work());
  return layout;
}

std::vector<PlaceId> places_of(const Snapshot& snapshot) {
  std::vector<PlaceId> places;
  for (const auto& [id, experience] : snapshot.experiences()) {
    for (const Place& place : experience->places) places.push_back(place.id);
  }
  return places;
}

/// Expects that positions and covariances agree to rounding.
void expect_alike(const Layout& one, const Layout& other, const Snapshot& snapshot) {
  EXPECT_EQ(one.laid(), snapshot.place_count());
  EXPECT_EQ(other.laid(), snapshot.place_count());
  for (const PlaceId& place : places_of(snapshot)) {
    const std::optional<Spot> a = one.spot(place);
    const std::optional<Spot> b = other.spot(place);
    ASSERT_TRUE(a && b) << to_string(place);
    EXPECT_LT((a->part_from_place.translation() - b->part_from_place.translation()).norm(), 1e-9);
    EXPECT_NEAR(wrap_angle(a->part_from_place.heading - b->part_from_place.heading), 0.0, 1e-9);
    EXPECT_LT((a->spread.matrix() - b->spread.matrix()).norm(), 1e-9 * (1.0 + b->spread.matrix().norm()));
  }
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    const PlaceId p = pick_place(random, snapshot);
    const PlaceId q = pick_place(random, snapshot);
    const Spot p_one = *one.spot(p);
    const Spot q_one = *one.spot(q);
    const Spot p_other = *other.spot(p);
    const Spot q_other = *other.spot(q);
    ASSERT_EQ(p_one.part == q_one.part, p_other.part == q_other.part);
    if (p_one.part != q_one.part) continue;
    EXPECT_NEAR(one.clearance_m(p_one, q_one), other.clearance_m(p_other, q_other), 1e-7);
  }
}

TEST(Layout, KeptUpWithBatchesEqualsLaidAnew) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Snapshot snapshot;
    Layout layout(0.0);
    layout.lay(share(snapshot));
    std::vector<BatchPlan> plans;
    for (int i = 0; i < 4; ++i) {
      plans.push_back({ExperienceId{random.next() | 1U}, random_id<RobotId>(random), 0, 6, 2, "marks"});
    }
    for (int turn = 0; turn < 16; ++turn) {
      BatchPlan& plan = plans[random.below(plans.size())];
      ++plan.sequence;
      plan.stitches = static_cast<std::uint32_t>(random.below(4));  // some runs hang on nothing for a while
      const Batch batch = make_batch(random, snapshot, plan);
      snapshot = with(snapshot, batch);
      layout.joined(share(snapshot), batch);
      if (random.chance(0.6)) layout.work(random.below(40));  // often less than there is to do
    }
    layout.work(kAll);
    EXPECT_FALSE(layout.has_work());
    expect_alike(layout, laid_anew(share(snapshot), layout.roots()), snapshot);
  }
}

TEST(Layout, KeptUpWithEditsEqualsLaidAnew) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Snapshot snapshot = make_network(random, 4, 3, 6, 2);
    Layout layout(0.0);
    layout.lay(share(snapshot));
    for (int turn = 0; turn < 4; ++turn) {
      layout.work(random.below(60));
      const PlaceId gone = pick_place(random, snapshot);
      Removal removal;
      removal.places.push_back({gone.experience, gone.index, gone.index + 2});
      const Snapshot before = snapshot;
      snapshot = without(before, removal);
      layout.edited(share(snapshot), before);
      if (turn != 2) continue;
      layout.edited(share(before), snapshot);  // undone
      snapshot = before;
    }
    layout.work(kAll);
    EXPECT_FALSE(layout.has_work());
    expect_alike(layout, laid_anew(share(snapshot), layout.roots()), snapshot);
  }
}

/// A plan may follow the map of before an edit while the map is laid out anew.
TEST(Layout, SpotsThatWereKeptOverAnEditAreComparedAsTheyWere) {
  Random random(5);
  const Snapshot before = make_network(random, 4, 3, 6, 2);
  Layout layout(0.0);
  layout.lay(share(before));
  layout.work(kAll);
  std::vector<Spot> kept;
  for (const PlaceId& place : places_of(before)) kept.push_back(*layout.spot(place));
  const auto compared = [&](const auto& compare) {
    for (std::size_t i = 0; i < kept.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        if (kept[i].part == kept[k].part) compare(kept[i], kept[k]);
      }
    }
  };
  std::vector<double> clearances;
  compared([&](const Spot& a, const Spot& b) { clearances.push_back(layout.clearance_m(a, b)); });
  Removal removal;
  for (const auto& [id, experience] : before.experiences()) removal.places.push_back({id, 0, 2});
  layout.edited(share(without(before, removal)), before);
  std::size_t at = 0;
  compared([&](const Spot& a, const Spot& b) {
    EXPECT_LE(layout.clearance_m(a, b), clearances[at++] + 1e-9) << "no farther than it was known to be";
  });
  while (layout.has_work()) {
    layout.work(7);
    compared([&](const Spot& a, const Spot& b) { EXPECT_TRUE(std::isfinite(layout.clearance_m(a, b))); });
  }
}

TEST(Layout, SmallGainsOfLaidPlacesAreLeft) {
  Random random(3);
  Snapshot snapshot;
  Layout layout(0.05);
  layout.lay(share(snapshot));
  std::vector<BatchPlan> plans;
  for (int i = 0; i < 5; ++i) {
    plans.push_back({ExperienceId{random.next() | 1U}, random_id<RobotId>(random), 0, 10, 6, "marks"});
  }
  for (int turn = 0; turn < 30; ++turn) {
    BatchPlan& plan = plans[random.below(plans.size())];
    ++plan.sequence;
    const Batch batch = make_batch(random, snapshot, plan);
    snapshot = with(snapshot, batch);
    layout.joined(share(snapshot), batch);
    layout.work(kAll);
  }
  // However a place hangs, its position has a covariance, and no pair is certain to be apart by more than it is.
  const Layout anew = laid_anew(share(snapshot), layout.roots());
  for (int i = 0; i < 500; ++i) {
    const Spot a = *layout.spot(pick_place(random, snapshot));
    const Spot b = *layout.spot(pick_place(random, snapshot));
    if (a.part != b.part) continue;
    EXPECT_GE(a.spread.at(a.part_from_place.translation()).trace(), 0.0);
    EXPECT_LE(layout.clearance_m(a, b), Layout::distance_m(a, b));
    EXPECT_EQ(layout.are_near(a, b, 0.7), layout.clearance_m(a, b) <= 0.7);
  }
}

TEST(Layout, IsAskedForOnlyWhenItsPartIsDone) {
  Random random(1);
  const Layout::Network network = share(make_network(random, 3, 3, 10, 4));
  Layout layout;
  layout.lay(network);
  EXPECT_FALSE(layout.work(20));
  EXPECT_EQ(layout.laid(), 0U);
  EXPECT_GT(layout.under_way(), 5U);
  EXPECT_FALSE(layout.spot(network->experiences().begin()->second->places.front().id));
  EXPECT_TRUE(layout.work(kAll));
  EXPECT_EQ(layout.laid(), network->place_count());
}

TEST(Layout, UncertaintyOfTwoPlacesIsThatOfTheBranchesBetweenThem) {
  // A bend of uncertain heading, and behind it, 50 m on, two places half a metre apart.
  Random random(1);
  BatchPlan plan{ExperienceId{1}, random_id<RobotId>(random), 1, 4, 0, "marks"};
  Batch batch = make_batch(random, Snapshot(), plan);
  const auto metric = [](double x, double sigma_rad) {
    Metric2 relation{{x, 0.0, 0.0}, Eigen::Matrix3d::Zero()};
    relation.covariance(2, 2) = sigma_rad * sigma_rad;
    return relation;
  };
  batch.edges[0].a_from_b = metric(0.1, 0.1);
  batch.edges[1].a_from_b = metric(50.0, 1e-4);
  batch.edges[2].a_from_b = metric(0.5, 1e-4);
  const Layout layout = laid_anew(share(with(Snapshot(), batch)));
  const Spot first = *layout.spot({ExperienceId{1}, 0});
  const Spot third = *layout.spot({ExperienceId{1}, 2});
  const Spot fourth = *layout.spot({ExperienceId{1}, 3});
  EXPECT_GT(fourth.sigma_m, 4.5) << "against the first one";
  EXPECT_NEAR(layout.clearance_m(third, fourth), 0.5, 0.01) << "against each other";
  EXPECT_NEAR(layout.clearance_m(first, fourth), 50.6 - 3 * 0.15 * 5.0, 0.5) << "what an arc takes off its length";
}

}  // namespace
}  // namespace weft::server::test
