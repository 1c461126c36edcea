#include "server/traffic/plan/planner.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace weft::server::test
