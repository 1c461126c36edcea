#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "core/network/removal.hpp"
#include "tests/support/network_maker.hpp"

namespace weft {
namespace {

struct Removals : testing::Test {
  Random random{3};
  Snapshot whole = support::make_network(random);
  ExperienceId one = whole.experiences().begin()->first;
  Stretch all{one, 0, std::numeric_limits<std::uint32_t>::max()};
};

TEST_F(Removals, PresentIsCutToWhatIsInTheMap) {
  const std::uint32_t last = whole.experience(one)->extent - 1;
  EXPECT_EQ(present(whole, {{all}, {}}).places, (std::vector<Stretch>{{one, 0, last}}));
  const Snapshot holed = without(whole, {{{one, 3, 5}}, {}});
  EXPECT_EQ(present(holed, {{all}, {}}).places, (std::vector<Stretch>{{one, 0, 2}, {one, 6, last}}));
  EXPECT_EQ(present(holed, {{{one, 2, 2}, {one, 1, 4}}, {}}).places, (std::vector<Stretch>{{one, 1, 2}}))
      << "stretches that overlap are one";
  EXPECT_TRUE(present(holed, {{{one, 3, 5}}, {}}).empty());
  EXPECT_TRUE(present(whole, {{{ExperienceId{77}, 0, 5}}, {}}).empty()) << "an experience that there is not";
}

TEST_F(Removals, AbsentIsWhatCouldComeBack) {
  EXPECT_TRUE(absent(whole, {{all}, {}}).empty());
  const Snapshot holed = without(whole, {{{one, 3, 5}}, {}});
  EXPECT_EQ(absent(holed, {{all}, {}}).places, (std::vector<Stretch>{{one, 3, 5}}));
  EXPECT_EQ(place_count(absent(holed, {{{one, 4, 9}}, {}})), 2U);
}

TEST_F(Removals, StitchesAreInOrOutOnce) {
  std::vector<EdgeId> stitches;
  for (const Edge& stitch : whole.experience(one)->stitches) stitches.push_back(stitch.id);
  ASSERT_GE(stitches.size(), 2U);
  const EdgeId first = stitches.front();
  EXPECT_EQ(present(whole, {{}, {first, first}}).stitches, (std::vector<EdgeId>{first}));
  const Snapshot thinner = without(whole, {{}, {first}});
  EXPECT_TRUE(present(thinner, {{}, {first}}).empty());
  EXPECT_EQ(absent(thinner, {{}, stitches}).stitches, (std::vector<EdgeId>{first}));
}

// A robot that has not heard yet that a place is gone hands in what it has seen beside it.
TEST_F(Removals, AStitchToWhatWasTakenOutDoesNotCostTheBatch) {
  const Snapshot holed = without(whole, {{{one, 3, 5}}, {}});
  support::BatchPlan plan{.experience = {4711}, .robot = support::random_id<RobotId>(random), .stitches = 0};
  Batch batch = support::make_batch(random, holed, plan);
  batch.edges.push_back(support::make_stitch(random, {one, 4}, batch.places[1].id, plan.method));
  batch.edges.push_back(support::make_stitch(random, {one, 2}, batch.places[2].id, plan.method));
  EXPECT_TRUE(check(holed, batch).empty());
  const Snapshot joined = with(holed, batch);
  EXPECT_EQ(joined.experience(plan.experience)->places.size(), batch.places.size());
  EXPECT_EQ(joined.experience(plan.experience)->stitches.size(), 1U) << "the other end of one of them is out";
  batch.edges.back().id.a.index = 1000;
  EXPECT_FALSE(check(holed, batch).empty()) << "a place that never was";
}

}  // namespace
}  // namespace weft
