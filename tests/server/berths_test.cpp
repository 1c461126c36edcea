#include "server/traffic/plan/berths.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "server/traffic/plan/cuts.hpp"
#include "tests/server/surveyed_site.hpp"

namespace weft::server::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

constexpr double kFootprint_m = 0.3;  // two robots keep 1.2 m apart
const std::set<std::string> kFloor = {"floor"};

struct BerthsTest : testing::Test {
  void follow() {
    proximity.emplace(proximity_of(site.network()));
    berths.emplace(*proximity);
    berths->follow({shared(site.network()), &no_rules}, kFootprint_m);
    methods = berths->methods({kFloor, true});
  }
  std::vector<PlaceId> ends(const PlaceId& from) {
    std::vector<PlaceId> all;
    for (const BerthArc& arc : berths->next(berths->at(from), methods)) all.push_back(berths->place(arc.to));
    return all;
  }

  SurveyedSite site{1};
  std::optional<Proximity> proximity;
  const RuleMap no_rules;
  std::optional<Berths> berths;
  std::uint32_t methods = 0;
};

TEST_F(BerthsTest, ARunIsCutWhereRobotsCanStandOneBehindAnother) {
  const std::uint64_t run = site.teach(Lane({0.0, 0.0, 0.0}).ahead(6.0));
  const std::vector<std::uint32_t> cuts = cuts_of(*site.network().experience(ExperienceId{run}),
                                                  {.room_m = 1.2,
                                                   .are_clear = [](const PlaceId&, const PlaceId&) { return true; },
                                                   .is_taken = [](const PlaceId&) { return false; }});
  EXPECT_THAT(cuts, ElementsAre(0, 5, 10, 15, 20));
}

TEST_F(BerthsTest, OneDrivesFromACutToTheNextAndNotBack) {
  const std::uint64_t run = site.teach(Lane({0.0, 0.0, 0.0}).ahead(6.0));
  follow();
  EXPECT_THAT(ends(SurveyedSite::place(run, 5)), ElementsAre(SurveyedSite::place(run, 10)));
  EXPECT_THAT(ends(SurveyedSite::place(run, 20)), IsEmpty());
  EXPECT_THAT(berths->beside(berths->at(SurveyedSite::place(run, 5))), IsEmpty());
}

TEST_F(BerthsTest, AGoalBetweenCutsIsABerthOfItsOwnWhereOneMayDriveOn) {
  const std::uint64_t run = site.teach(Lane({0.0, 0.0, 0.0}).ahead(6.0));
  follow();
  const Berth goal = berths->at(SurveyedSite::place(run, 7));
  EXPECT_FALSE(berths->is_cut(goal));
  EXPECT_THAT(ends(SurveyedSite::place(run, 5)),
              ElementsAre(SurveyedSite::place(run, 7), SurveyedSite::place(run, 10)));
  EXPECT_THAT(berths->beside(goal), Contains(berths->at(SurveyedSite::place(run, 5))));
}

TEST_F(BerthsTest, WhatLiesAroundIsLookedUpInTheLatestMapThoughAnEarlierOneIsFollowed) {
  const std::uint64_t run = site.teach(Lane({0.0, 0.0, 0.0}).ahead(6.0));
  follow();
  const Snapshot before = site.network();
  const std::uint64_t other = site.teach(Lane({0.0, 0.1, 0.0}).ahead(6.0));
  site.stitch(SurveyedSite::place(run, 0), SurveyedSite::place(other, 0));
  proximity->edited(shared(site.network()), before);
  berths->see(shared(site.network()));
  berths->beside(berths->at(SurveyedSite::place(run, 7)));
  const LocatedPlace here =
      proximity->locate(TrafficMap(site.network()), Touched{.place = SurveyedSite::place(run, 7), .reach_m = 0.3});
  EXPECT_THAT(*here.around, Contains(testing::Field(&Near::place, SurveyedSite::place(other, 7))))
      << "leases would not see who stands there";
}

TEST_F(BerthsTest, RunsOverOneFloorAreBesideEachOther) {
  const std::uint64_t run = site.teach(Lane({0.0, 0.0, 0.0}).ahead(6.0));
  const std::uint64_t other = site.teach(Lane({0.0, 0.5, 0.0}).ahead(6.0));
  site.stitch(SurveyedSite::place(run, 0), SurveyedSite::place(other, 0));
  follow();
  // It begins at a berth of the first run: its own come a room later.
  EXPECT_FALSE(berths->is_cut(SurveyedSite::place(other, 0)));
  EXPECT_TRUE(berths->is_cut(SurveyedSite::place(other, 5)));
  const Berth berth = berths->at(SurveyedSite::place(run, 5));
  EXPECT_THAT(berths->beside(berth), ElementsAre(berths->at(SurveyedSite::place(other, 5))));
  const std::vector<BerthArc>& arcs = berths->next(berths->at(SurveyedSite::place(other, 5)), methods);
  ASSERT_THAT(arcs, SizeIs(1));
  EXPECT_THAT(arcs[0].touches, Contains(berths->at(SurveyedSite::place(run, 10))));
  EXPECT_THAT(arcs[0].touches, Not(Contains(berths->at(SurveyedSite::place(run, 0)))));
}

TEST_F(BerthsTest, WhoDrivesOtherMethodsHasNoWay) {
  const std::uint64_t run = site.teach(Lane({0.0, 0.0, 0.0}).ahead(6.0));
  follow();
  const std::uint32_t others = berths->methods({{"marks"}, true});
  EXPECT_NE(others, methods);
  EXPECT_THAT(berths->next(berths->at(SurveyedSite::place(run, 5)), others), IsEmpty());
}

TEST_F(BerthsTest, AMapThatIsCutRunByRunIsCutAlike) {
  for (const double y : {0.0, 5.0, 10.0}) site.teach(Lane({0.0, y, 0.0}).ahead(12.0));
  follow();
  Berths divided(*proximity);
  ASSERT_TRUE(divided.begin_to_follow({shared(site.network()), &no_rules}, kFootprint_m));
  EXPECT_FALSE(divided.cut(1));
  EXPECT_FALSE(divided.cut(1));
  EXPECT_TRUE(divided.cut(1));
  for (std::uint64_t run = 1; run <= 3; ++run) {
    for (std::uint32_t index = 0; index < site.places(run); ++index) {
      const PlaceId place = SurveyedSite::place(run, index);
      EXPECT_EQ(divided.is_cut(place), berths->is_cut(place)) << to_string(place);
    }
  }
}

TEST_F(BerthsTest, NothingIsMadeAnewWhileTheMapIsTheSame) {
  site.teach(Lane({0.0, 0.0, 0.0}).ahead(6.0));
  follow();
  const RuledNetwork network{shared(site.network()), &no_rules};
  EXPECT_TRUE(berths->follow(network, kFootprint_m));
  EXPECT_FALSE(berths->follow(network, kFootprint_m));
  EXPECT_TRUE(berths->follow(network, kFootprint_m + 0.1));
}

}  // namespace
}  // namespace weft::server::test
