#include "agents/agent/missions/search_policy.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

Estimate standing_beside(double metres) {
  return {PlaceId{ExperienceId{1}, 0}, Metric2{Pose2{metres, 0.0, 0.0}, Eigen::Matrix3d::Zero()}, 0.0};
}

Window map_of_one_place(std::uint64_t revision) {
  Window window;
  window.revision.value = revision;
  const Place place = a_place(ExperienceId{1}, 0, {}, some_content(1, 10));
  window.places.emplace(place.id, place);
  return window;
}

struct PolicyTest : testing::Test {
  /// Returns whether a search is due when the last one was in revision 1, long ago.
  bool is_due(const SearchPolicy::Situation& situation, std::uint64_t revision) {
    SearchPolicy policy(SteadyTime{});
    policy.begins(map_of_one_place(1), SteadyTime{});
    return policy.is_due(map_of_one_place(revision), situation, SteadyTime{} + 1h);
  }
};
using SearchPolicyTest = PolicyTest;

TEST_F(SearchPolicyTest, RobotThatKnowsNothingLooksOnceInARevisionAndOnAndOnWithARoute) {
  EXPECT_FALSE(is_due({}, 1));
  EXPECT_TRUE(is_due({}, 2));
  EXPECT_TRUE(is_due({.estimate = {}, .has_route = true}, 1));
  EXPECT_TRUE(is_due({.estimate = {}, .has_route = true, .strays = false, .is_held = true}, 1));
}

TEST_F(SearchPolicyTest, RobotThatMayBeMistakenLooksBeforeARouteIsPlanned) {
  EXPECT_TRUE(is_due({.estimate = standing_beside(0.6)}, 2));
  EXPECT_FALSE(is_due({.estimate = standing_beside(0.6)}, 1));
  EXPECT_FALSE(is_due({.estimate = standing_beside(0.4)}, 2));
  EXPECT_FALSE(is_due({.estimate = standing_beside(0.6), .has_route = true}, 2));
}

TEST_F(SearchPolicyTest, RobotWhoseRouteLiesElsewhereLooksInTheSameRevisionAgain) {
  SearchPolicy::Situation strays{.estimate = standing_beside(0.1), .has_route = true, .strays = true};
  EXPECT_TRUE(is_due(strays, 1));
  strays.is_held = true;
  EXPECT_FALSE(is_due(strays, 2));
}

TEST_F(SearchPolicyTest, NothingIsDueWithoutAMapOrAWorkingBody) {
  SearchPolicy policy(SteadyTime{});
  EXPECT_TRUE(policy.is_due(map_of_one_place(1), {}, SteadyTime{}));
  EXPECT_FALSE(policy.is_due(Window{}, {}, SteadyTime{}));
  SearchPolicy::Situation broken;
  broken.is_out_of_order = true;
  EXPECT_FALSE(policy.is_due(map_of_one_place(1), broken, SteadyTime{}));
}

TEST_F(SearchPolicyTest, SearchesAreTenSecondsApartWhoeverAskedForTheLast) {
  SearchPolicy policy(SteadyTime{});
  policy.begins(map_of_one_place(1), SteadyTime{} + 5s);
  EXPECT_FALSE(policy.is_due(map_of_one_place(2), {}, SteadyTime{} + 14s));
  EXPECT_TRUE(policy.is_due(map_of_one_place(2), {}, SteadyTime{} + 15s));
}

}  // namespace
}  // namespace weft::agents::test
