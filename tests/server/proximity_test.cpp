#include "server/traffic/proximity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/network/apart.hpp"
#include "tests/server/surveyed_site.hpp"

namespace weft::server::test {
namespace {

constexpr double kReach_m = 0.28 + kLeastSlack_m;  // of a robot between two places
constexpr double kTouch_m = 0.56;
constexpr double kPi = std::numbers::pi;

bool meet(Proximity& proximity, const TrafficMap& map, const PlaceId& a, const PlaceId& b) {
  const std::vector<Touched> of_a = {{.place = a, .reach_m = kReach_m}};
  const std::vector<Touched> of_b = {{.place = b, .reach_m = kReach_m}};
  return proximity.overlap(map, of_a, of_b);
}

struct Seen {
  int touching_and_not_near = 0;
  int near_beyond = 0;  ///< farther apart than `clear_m`
};

/// Looks at all pairs of places of two runs, or of one.
Seen all_pairs(const SurveyedSite& site, std::uint64_t a, std::uint64_t b, double clear_m) {
  Proximity proximity = proximity_of(site.network());
  Seen seen;
  for (std::uint32_t i = 0; i < site.places(a); ++i) {
    for (std::uint32_t k = 0; k < site.places(b); ++k) {
      const PlaceId p = SurveyedSite::place(a, i);
      const PlaceId q = SurveyedSite::place(b, k);
      const double truly_m = site.distance_m(p, q);
      if (truly_m > kTouch_m && truly_m < clear_m) continue;
      const bool is_near = meet(proximity, site.network(), p, q);
      if (truly_m <= kTouch_m && !is_near) ++seen.touching_and_not_near;
      if (truly_m >= clear_m && is_near) ++seen.near_beyond;
    }
  }
  return seen;
}

TEST(Proximity, AisleDrivenThereAndBackIsOneFloor) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SurveyedSite site(seed);
    const std::uint64_t run = site.teach(Lane({}).ahead(20.0).bend(kPi, 0.5).ahead(20.0));
    const Seen seen = all_pairs(site, run, run, 2.2);
    EXPECT_EQ(seen.touching_and_not_near, 0) << "seed " << seed;
    EXPECT_EQ(seen.near_beyond, 0) << "seed " << seed;
  }
}

TEST(Proximity, LanesThatCrossMeetAtTheCrossing) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    SurveyedSite site(seed);
    // A figure of eight: straight over the crossing, three quarters of a circle, and over it again at 90 degrees.
    Lane eight({-4.0, 0.0, 0.0});
    eight.ahead(8.0).bend(1.5 * kPi, 1.5 * kPi * 4.0).ahead(8.0).bend(-1.5 * kPi, 1.5 * kPi * 4.0);
    const std::uint64_t run = site.teach(eight);
    const Seen seen = all_pairs(site, run, run, 2.2);
    EXPECT_EQ(seen.touching_and_not_near, 0) << "seed " << seed;
    EXPECT_EQ(seen.near_beyond, 0) << "seed " << seed;
  }
}

TEST(Proximity, ParallelAislesDoNotConflict) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    SurveyedSite site(seed);
    // Loops of 39 m side by side; the aisle between two of them is driven in both, and stitched over 10 m.
    const double bend_m = 1.8 * kPi / 2;
    const auto loop = [&](double y) {
      Lane lane({0.0, y, 0.0});
      return lane.ahead(13.75).bend(kPi, 2 * bend_m).ahead(13.75).bend(kPi, 2 * bend_m - 0.5);
    };
    const std::uint64_t first = site.teach(loop(0.0));
    const std::uint64_t second = site.teach(loop(3.6));
    const std::uint64_t third = site.teach(loop(7.2));
    const auto join = [&](std::uint64_t lower, std::uint64_t upper) {
      for (std::uint32_t i = 8; i < 48; i += 4) {
        PlaceId nearest = SurveyedSite::place(lower, 0);
        for (std::uint32_t k = 0; k < site.places(lower); ++k) {
          const PlaceId at = SurveyedSite::place(lower, k);
          const PlaceId here = SurveyedSite::place(upper, i);
          if (site.distance_m(at, here) < site.distance_m(nearest, here)) nearest = at;
        }
        site.stitch(nearest, SurveyedSite::place(upper, i));
      }
    };
    join(first, second);
    join(second, third);
    for (const auto& [a, b] : {std::pair{first, first}, {first, second}, {first, third}, {second, third}}) {
      const Seen seen = all_pairs(site, a, b, 2.4);
      EXPECT_EQ(seen.touching_and_not_near, 0) << "seed " << seed;
      EXPECT_EQ(seen.near_beyond, 0) << "seed " << seed << ": the next aisle is 3.6 m away";
    }
  }
}

TEST(Proximity, LoopOfTwoHundredMetresMeetsItsBeginning) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SurveyedSite site(seed);
    Lane loop({});
    for (int side = 0; side < 4; ++side) loop.ahead(47.0).bend(kPi / 2, 3.0);
    const std::uint64_t run = site.teach(loop.ahead(5.0));  // over its beginning
    Proximity proximity = proximity_of(site.network());
    const PlaceId first = SurveyedSite::place(run, 10);
    PlaceId last = SurveyedSite::place(run, site.places(run) - 1);
    while (site.distance_m(first, last) > 0.3) --last.index;
    EXPECT_TRUE(meet(proximity, site.network(), first, last)) << "seed " << seed;
    const PlaceId across = SurveyedSite::place(run, 200 * 2 + 10);
    EXPECT_FALSE(meet(proximity, site.network(), first, across)) << "seed " << seed;
  }
}

TEST(Proximity, NeighboursWhoseBranchesPartFarAwayAreSeenFromNearby) {
  SurveyedSite site(1);
  // Two lanes of 300 m side by side, joined at both ends; the tree of the whole parts them at one of these.
  Lane there({});
  Lane back({0.0, 4.0, 0.0});
  const std::uint64_t first = site.teach(there.ahead(300.0));
  const std::uint64_t second = site.teach(back.ahead(300.0));
  Lane near_end({0.0, 0.0, kPi / 2});
  Lane far_end({300.0, 0.0, kPi / 2});
  const std::uint64_t third = site.teach(near_end.ahead(4.0));
  const std::uint64_t fourth = site.teach(far_end.ahead(4.0));
  site.stitch(SurveyedSite::place(first, 0), SurveyedSite::place(third, 0));
  site.stitch(SurveyedSite::place(third, 16), SurveyedSite::place(second, 0));
  site.stitch(SurveyedSite::place(first, 1200), SurveyedSite::place(fourth, 0));
  site.stitch(SurveyedSite::place(fourth, 16), SurveyedSite::place(second, 1200));
  Proximity proximity = proximity_of(site.network());
  for (const std::uint32_t at : {20U, 1180U}) {
    const Spot a = *proximity.layout().spot(SurveyedSite::place(first, at));
    const Spot b = *proximity.layout().spot(SurveyedSite::place(second, at));
    EXPECT_EQ(proximity.layout().are_near(a, b, 2 * kReach_m + kMargin_m), at == 1180U) << "by the whole";
    EXPECT_FALSE(meet(proximity, site.network(), SurveyedSite::place(first, at), SurveyedSite::place(second, at)));
  }
}

TEST(Proximity, WhereOnlyTheWayIsMeasuredLanesBesideOneAnotherMayMeet) {
  // There and back by what was travelled and turned; nothing says how far the ways lie beside one another.
  Batch batch;
  batch.experience = ExperienceId{1};
  for (std::uint32_t i = 0; i <= 81; ++i) {
    Place place;
    place.id = {batch.experience, i};
    batch.places.push_back(place);
    if (i == 0) continue;
    Edge edge;
    edge.id = {{batch.experience, i - 1}, place.id};
    edge.a_from_b = i == 41 ? AlongPath{0.5, 0.0004, kPi, 0.0025} : AlongPath{0.25, 0.0001, 0.0, 0.0004};
    batch.edges.push_back(edge);
  }
  const Snapshot network = with(Snapshot(), batch);
  Proximity proximity = proximity_of(network);
  const auto place = [](std::uint32_t index) { return SurveyedSite::place(1, index); };
  for (std::uint32_t i = 0; i < 40; i += 5) EXPECT_TRUE(meet(proximity, network, place(i), place(81 - i))) << i;
  EXPECT_TRUE(meet(proximity, network, place(8), place(70))) << "a metre beside it, as far as is known";
  EXPECT_FALSE(meet(proximity, network, place(0), place(40))) << "10 m on along the path";
}

TEST(Proximity, WordOfAnOperatorOutweighsWhereTheyAreReckonedToBe) {
  SurveyedSite site(1);
  const std::uint64_t run = site.teach(Lane({}).ahead(15.0).bend(kPi, 0.5).ahead(15.0));
  const PlaceId there = SurveyedSite::place(run, 20);
  const PlaceId back = SurveyedSite::place(run, 102);
  ASSERT_LT(site.distance_m(there, back), kTouch_m);
  Proximity before = proximity_of(site.network());
  EXPECT_TRUE(meet(before, site.network(), there, back));
  const Snapshot apart = with_apart(site.network(), {{ExperienceId{run}, 0, 30}, {ExperienceId{run}, 92, 120}});
  Proximity proximity = proximity_of(apart);
  EXPECT_FALSE(meet(proximity, apart, there, back));
  EXPECT_TRUE(meet(proximity, apart, SurveyedSite::place(run, 40), SurveyedSite::place(run, 82)));
  site.stitch(there, back);
  const Snapshot measured = with_apart(site.network(), {{ExperienceId{run}, 0, 30}, {ExperienceId{run}, 92, 120}});
  Proximity beside = proximity_of(measured);
  EXPECT_TRUE(meet(beside, measured, there, back)) << "a relation that was measured between them counts";
}

TEST(Proximity, WhatWasTakenOutStaysNearWhatItWasNear) {
  SurveyedSite site(1);
  const std::uint64_t first = site.teach(Lane({}).ahead(10.0));
  // Beside it 20 m later, and joined at its beginning alone.
  Lane other({0.0, 0.3, 0.0});
  const std::uint64_t second = site.teach(other.bend(2 * kPi, 20.0).ahead(10.0));
  site.stitch(SurveyedSite::place(first, 0), SurveyedSite::place(second, 0));
  const PlaceId held = SurveyedSite::place(second, 100);
  const PlaceId wanted = SurveyedSite::place(first, 20);
  ASSERT_LT(site.distance_m(held, wanted), kTouch_m);
  const Snapshot before = site.network();
  Proximity proximity = proximity_of(before);
  ASSERT_TRUE(meet(proximity, before, held, wanted));
  Removal removal;
  removal.places.push_back({ExperienceId{second}, 0, site.places(second) - 1});
  const Snapshot after = without(before, removal);
  const TrafficMap::History history = {shared(before)};
  const TrafficMap map(after, history);
  proximity.edited(shared(after), before);
  proximity.layout().work(100'000);
  EXPECT_TRUE(meet(proximity, map, held, wanted));
  EXPECT_FALSE(meet(proximity, map, held, SurveyedSite::place(first, 40)));
}

TEST(Proximity, PartsThatNothingJoinsKnowNothingOfEachOther) {
  SurveyedSite site(1);
  const std::uint64_t first = site.teach(Lane({}).ahead(5.0));
  const std::uint64_t second = site.teach(Lane({}).ahead(5.0));
  Proximity proximity = proximity_of(site.network());
  EXPECT_FALSE(meet(proximity, site.network(), SurveyedSite::place(first, 3), SurveyedSite::place(second, 3)));
}

}  // namespace
}  // namespace weft::server::test
