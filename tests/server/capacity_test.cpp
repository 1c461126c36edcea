#include "server/dispatcher/capacity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/one_run.hpp"

namespace weft::server::test {
namespace {

using testing::HasSubstr;

/// Arranges a run of which a rule lets one robot at a time hold the places 20 to 40.
struct Capacity : OneRun {
  Capacity() {
    site.label("end", run.place(55));
    site.say(site.state(r1, run.place(0)));
    put(1);
    site.hush();
  }
  void put(int most) {
    const Rule rule{.name = "room",
                    .kind = RuleKind::capacity,
                    .value = static_cast<double>(most),
                    .spans = {{run.place(20), run.place(40)}}};
    ASSERT_EQ(site.put_rule(rule).outcome, msg::Outcome::done);
  }
  RuleMap rules() { return RuleMap(site.service().snapshot()); }
  /// Returns the route along the run from one place to another.
  Route along(std::uint32_t from, std::uint32_t to) {
    Route route;
    for (std::uint32_t place = from; place <= to; ++place) route.places.push_back(run.place(place));
    return route;
  }
};

TEST_F(Capacity, ARouteEndsBeforeASetThatIsFull) {
  const HeldPlaces inside{{r2.id, {run.place(40)}}};
  const HeldPlaces outside{{r2.id, {run.place(41)}}};
  const ReleasedByRules full = released_by_capacity(rules(), along(10, 50), 0, 40, inside);
  EXPECT_EQ(full.through, 9U);
  EXPECT_EQ(full.rule, "room");
  const ReleasedByRules free = released_by_capacity(rules(), along(10, 50), 0, 40, outside);
  EXPECT_EQ(free.through, 40U);
  EXPECT_EQ(free.rule, "");
}

TEST_F(Capacity, AsManyAsItSaysAreLetIn) {
  put(2);
  const HeldPlaces one{{r2.id, {run.place(40)}}};
  EXPECT_EQ(released_by_capacity(rules(), along(10, 50), 0, 40, one).through, 40U);
  const HeldPlaces two{{r2.id, {run.place(40)}}, {robot_id(3), {run.place(19), run.place(20)}}};
  EXPECT_EQ(released_by_capacity(rules(), along(10, 50), 0, 40, two).through, 9U);
}

TEST_F(Capacity, WhoIsInsideMayLeave) {
  const HeldPlaces inside{{r2.id, {run.place(40)}}};
  EXPECT_EQ(released_by_capacity(rules(), along(25, 50), 0, 25, inside).through, 25U);
}

TEST_F(Capacity, WhoStandsRightBeforeItIsReleasedNoFarther) {
  const HeldPlaces inside{{r2.id, {run.place(40)}}};
  const ReleasedByRules full = released_by_capacity(rules(), along(10, 50), 9, 40, inside);
  EXPECT_FALSE(full.through);
  EXPECT_EQ(full.rule, "room");
  EXPECT_EQ(released_by_capacity(rules(), along(10, 50), 9, std::nullopt, inside).rule, "room")
      << "it is the next thing, also where others are in the way";
}

TEST_F(Capacity, TheNextOneWaitsBeforeItAndNamesTheRule) {
  site.arrive(r2, std::nullopt);
  site.stand_stopped(r2, run.place(38));
  site.send_goal(1, "end", "r1");
  site.pass(1s);
  const Route route = site.order();
  EXPECT_LT(route.released, 20U);
  EXPECT_GE(route.released, 14U);
  EXPECT_THAT(site.why(1), HasSubstr("r1 waits until rule room lets it on"));
  site.progress(r1, route, msg::RoutePhase::waiting);
  site.pass(3s);
  EXPECT_EQ(site.row("r1").wait.rule, "room");
  site.stand_stopped(r2, run.place(59));
  site.pass(3s);
  EXPECT_GE(site.order().released, 20U);
}

}  // namespace
}  // namespace weft::server::test
