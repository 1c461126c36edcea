#include "server/traffic/plan/planner.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/server/surveyed_site.hpp"

namespace weft::server::test {
namespace {

/// A robot at the beginning of a lane, with a goal at its end.
struct PlannerTest : testing::Test {
  PlannerTest() {
    run = site.teach(Lane({}).ahead(12.0));
    PlanRequest request;
    request.robot = RobotId{1, 1};
    request.held = {SurveyedSite::place(run, 0)};
    request.goal = SurveyedSite::place(run, 40);
    request.drives = {{"floor"}, true};
    requests = {request};
  }
  void lay_out() {
    proximity.layout().lay(shared(site.network()));
    proximity.layout().work(1'000'000);
  }
  /// Returns whether the latest map was planned on.
  bool plan() { return planner.plan({shared(site.network()), &rules}, 0.3, requests); }

  SurveyedSite site{1};
  std::uint64_t run = 0;
  const RuleMap rules;
  Proximity proximity{2.2};
  Planner planner{proximity, {}};
  std::vector<PlanRequest> requests;
};

TEST_F(PlannerTest, NobodyMovesBeforeItIsKnownWhereTheMapLies) {
  EXPECT_FALSE(plan());
  EXPECT_EQ(planner.may(0, 0), 0U);
  EXPECT_TRUE(planner.waits_for(0).empty());
  lay_out();
  EXPECT_TRUE(plan());
  EXPECT_GT(planner.may(0, 0), 0U);
}

TEST_F(PlannerTest, WhileItIsLaidOutAnewTheEarlierMapIsPlannedOn) {
  lay_out();
  ASSERT_TRUE(plan());
  proximity.layout().lay(shared(site.network()));
  EXPECT_FALSE(plan());
  EXPECT_GT(planner.may(0, 0), 0U);
  proximity.layout().work(1'000'000);
  EXPECT_TRUE(plan());
}

TEST_F(PlannerTest, NobodyIsLedUpToWhereADeadRobotHoldsAnything) {
  lay_out();
  PlanRequest dead = requests.front();
  dead.robot = RobotId{2, 2};
  dead.goal.reset();
  dead.stays = dead.stands_for_long = true;
  requests.push_back(dead);
  const auto touched = [this](std::uint32_t index) {
    return Touched{.place = SurveyedSite::place(run, index), .reach_m = 0.3 + kLeastSlack_m};
  };
  for (std::uint32_t first = 20; first < 28; ++first) {
    requests.back().held.clear();
    for (std::uint32_t index = first; index < first + 6; ++index) {
      requests.back().held.push_back(SurveyedSite::place(run, index));
    }
    ASSERT_TRUE(plan());
    const auto moves = static_cast<std::uint32_t>(planner.order().moves(0).size());
    ASSERT_GT(moves, 0U);
    const PlaceId end = planner.way(0, 0, moves).places.back();
    EXPECT_FALSE(
        proximity.overlap(TrafficMap(site.network()), std::vector{touched(end.index)}, std::vector{touched(first)}))
        << to_string(end) << " and " << first;
  }
}

TEST_F(PlannerTest, WhoMakesWayWhereTheMapHasNoPlaceAnyMoreStays) {
  lay_out();
  requests.push_back(requests.front());
  requests.back().robot = RobotId{2, 2};
  requests.back().held = {SurveyedSite::place(run + 100, 0)};
  requests.back().goal.reset();
  ASSERT_TRUE(plan());
  EXPECT_EQ(planner.may(1, 0), 0U);
}

/// Arranges an aisle that is driven both ways, with a loop off it that comes back to where it begins: one that wants
/// to the aisle's far end, and an idle one in there that faces it.
struct LoopTest : PlannerTest {
  LoopTest() {
    const std::uint64_t east = site.teach(Lane({}).ahead(90.0));
    const std::uint64_t west = site.teach(Lane({20.0, 0.0, std::numbers::pi}).ahead(90.0));
    const double half_m = 4.0 * std::numbers::pi;
    loop =
        site.teach(Lane({10.0, 0.0, 0.0}).bend(std::numbers::pi, half_m).ahead(10.0).bend(std::numbers::pi, half_m));
    site.stitch(SurveyedSite::place(east, 80), SurveyedSite::place(west, 0));
    site.stitch(SurveyedSite::place(east, 40), SurveyedSite::place(loop, 0));
    site.stitch(SurveyedSite::place(loop, site.places(loop) - 1), SurveyedSite::place(east, 0));
    lay_out();
    requests.front().held = {SurveyedSite::place(east, 20)};
    requests.front().goal = SurveyedSite::place(east, 120);
    requests.push_back(requests.front());
    requests.back().robot = RobotId{2, 2};
    requests.back().held = {SurveyedSite::place(west, 0)};
    requests.back().goal.reset();
  }

  std::uint64_t loop = 0;
  Planner planner{proximity, {.steps = 10, .handling = 5}};
};

TEST_F(LoopTest, WhoWasLedOffForAnIdleRobotDoesNotFindItThereAgain) {
  const auto plan = [&] { return planner.plan({shared(site.network()), &rules}, 0.3, requests); };
  ASSERT_TRUE(plan());
  // It has driven off into the loop before the idle one was given its way: no step of the next plan comes back there.
  requests.front().held = {SurveyedSite::place(loop, 20)};
  ASSERT_TRUE(plan());
  EXPECT_GT(planner.order().moves(1).size(), 0U) << "it would be found there at each round";
  requests.front().goal = SurveyedSite::place(loop, 80);
  ASSERT_TRUE(plan());
  EXPECT_EQ(planner.order().moves(1).size(), 0U) << "nobody wants to go by any more";
}

TEST_F(LoopTest, WhoIsLedOffForAnIdleRobotIsReleasedLittleAtATime) {
  const auto plan = [&] { return planner.plan({shared(site.network()), &rules}, 0.3, requests); };
  ASSERT_TRUE(plan());
  requests.front().held = {SurveyedSite::place(loop, 20)};
  ASSERT_TRUE(plan());
  EXPECT_LE(planner.may(0, 0), 8U) << "it would hold all of the round, and the idle one could not drive out";
  requests.pop_back();
  ASSERT_TRUE(plan());
  EXPECT_GT(planner.may(0, 0), 8U) << "nobody else is to move";
}

/// Arranges a dead robot in an aisle that branches off a lane, one before its mouth that would go by it, and one that
/// comes behind that along the lane.
struct CutOffTest : PlannerTest {
  CutOffTest() {
    aisle = site.teach(Lane(site.pose(SurveyedSite::place(run, 24)) * Pose2{0.0, 0.0, 1.57}).ahead(6.0));
    site.stitch(SurveyedSite::place(run, 24), SurveyedSite::place(aisle, 0));
    lay_out();
    requests.resize(3, requests.front());
    requests[0].held = {SurveyedSite::place(run, 15)};
    PlanRequest& waits = requests[1];
    waits.robot = RobotId{2, 2};
    waits.held = {SurveyedSite::place(run, 20)};
    waits.goal = SurveyedSite::place(aisle, 23);
    for (std::uint32_t index = 0; index < 24; ++index) waits.ahead.push_back(SurveyedSite::place(aisle, index));
    PlanRequest& dead = requests[2];
    dead.robot = RobotId{3, 3};
    dead.held = {SurveyedSite::place(aisle, 5)};
    dead.goal.reset();
    dead.stays = dead.stands_for_long = dead.needs_help = true;
  }
  std::size_t moves(std::uint32_t robot) const { return planner.order().moves(robot).size(); }

  std::uint64_t aisle = 0;
};

TEST_F(CutOffTest, WhoKeepsOthersFromGoingOnMakesWay) {
  ASSERT_TRUE(plan());
  ASSERT_GT(moves(0), 0U);
  EXPECT_EQ(planner.way(0, 0, static_cast<std::uint32_t>(moves(0))).places.back(), requests[0].goal);
  EXPECT_GT(moves(1), 0U);
}

TEST_F(CutOffTest, WhoMakesWayMeanwhileWaitsForTheDeadOne) {
  requests.push_back(requests[1]);
  requests.back().robot = RobotId{4, 4};
  requests.back().held = {SurveyedSite::place(run, 4)};
  ASSERT_TRUE(plan());
  EXPECT_EQ(moves(3), 0U);
  EXPECT_EQ(planner.waits_for(3), std::vector<std::uint32_t>{2});
}

TEST_F(CutOffTest, WhoKeepsNobodyWaitsAsNearAsItComes) {
  requests.erase(requests.begin());
  ASSERT_TRUE(plan());
  EXPECT_EQ(moves(0), 0U);
  requests.back().held = {SurveyedSite::place(aisle, 15)};
  ASSERT_TRUE(plan());
  ASSERT_GT(moves(0), 0U);
  EXPECT_EQ(planner.way(0, 0, static_cast<std::uint32_t>(moves(0))).places.back().experience.value, aisle);
}

/// Plans anew from nothing, in pieces of so much, and returns each robot's planned places.
struct InPieces {
  InPieces(const SurveyedSite& site, const std::vector<PlanRequest>& requests, std::uint64_t most) {
    proximity.layout().lay(shared(site.network()));
    proximity.layout().work(1'000'000);
    EXPECT_TRUE(planner.begin({shared(site.network()), &rules}, 0.3, requests));
    for (; planner.is_under_way(); ++pieces) planner.work(most);
    for (std::uint32_t robot = 0; robot < requests.size(); ++robot) {
      const auto moves = static_cast<std::uint32_t>(planner.order().moves(robot).size());
      ways.push_back(planner.way(robot, 0, moves).places);
      waits_for.push_back(planner.waits_for(robot));
    }
  }
  const RuleMap rules;
  Proximity proximity{2.2};
  Planner planner{proximity, {}};
  std::size_t pieces = 0;
  std::vector<std::vector<PlaceId>> ways;
  std::vector<std::vector<std::uint32_t>> waits_for;
};

TEST_F(CutOffTest, HoweverAPlanIsDividedItIsTheSame) {
  const InPieces whole(site, requests, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(whole.pieces, 1U);
  EXPECT_FALSE(whole.ways[0].empty());
  for (const std::uint64_t most : {1U, 7U}) {
    const InPieces divided(site, requests, most);
    EXPECT_GT(divided.pieces, 30U);
    EXPECT_EQ(divided.ways, whole.ways) << "pieces of " << most;
    EXPECT_EQ(divided.waits_for, whole.waits_for) << "pieces of " << most;
  }
}

TEST_F(CutOffTest, WhoWaitsForOneThatNeedsNoHelpKeepsItsPlace) {
  requests.back().needs_help = false;
  ASSERT_TRUE(plan());
  EXPECT_EQ(moves(0), 0U);
  EXPECT_EQ(moves(1), 0U);
}

}  // namespace
}  // namespace weft::server::test
