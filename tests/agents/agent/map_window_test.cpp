#include "agents/agent/map_window.hpp"

#include <gtest/gtest.h>

#include "core/network/change.hpp"
#include "tests/agents/agent/bench.hpp"

/// Tests how the window's parts are put together, and the parts that need a window for that: its focus and its
/// anchor.
namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

struct MapBench : Bench {
  explicit MapBench(std::uint32_t places = 40) : laid(lay_out(server, 70, places)) {}
  void stand_on(std::uint32_t index) { script->estimate = Estimate{{laid, index}, Relation{}, 0.0}; }
  void recentre() { map.recentre(std::nullopt, context(), now); }
  std::optional<PlaceId> centre() const { return map.replica().definition().centre; }
  /// Shows the map a window of these places alone, as after an edit. Returns the note.
  std::string show_only(std::uint32_t first, std::uint32_t last) {
    msg::WindowPatch patch;
    patch.definition_id = map.window_due(now + 1h)->definition_id;  // by then it is due
    patch.parts = 1;
    Window target = map.window();
    std::vector<PlaceId> gone;
    for (const auto& [id, place] : target.places) {
      if (id.index < first || id.index > last) gone.push_back(id);
    }
    std::vector<EdgeId> cut;
    for (const auto& [id, edge] : target.edges) {
      if (id.a.index < first || id.b.index > last) cut.push_back(id);
    }
    target.places.erase_all(gone);
    target.edges.erase_all(cut);
    ++target.revision.value;
    index_edges(target);
    patch.patch = difference(Window{}, target);
    patch.patch.base = Revision{};
    patch.patch.digest = digest(target);
    return map.on_patch(patch, context(), goes_elsewhere, now);
  }
  ExperienceId laid;
  bool goes_elsewhere = false;
};

TEST(MapWindow, MovesWithTheRobotOncePerSecondAndNotForAFewHops) {
  MapBench bench;
  bench.fetch_map();
  bench.stand_on(20);
  bench.recentre();
  EXPECT_EQ(bench.centre(), (PlaceId{bench.laid, 20}));
  bench.fetch_map();
  bench.stand_on(28);
  bench.recentre();
  EXPECT_EQ(bench.centre(), (PlaceId{bench.laid, 20})) << "eight hops are near";
  bench.now += 1s;
  bench.stand_on(30);
  bench.recentre();
  EXPECT_EQ(bench.centre(), (PlaceId{bench.laid, 30}));
  bench.fetch_map();
  bench.stand_on(10);
  bench.recentre();
  bench.stand_on(39);
  bench.recentre();
  EXPECT_EQ(bench.centre(), (PlaceId{bench.laid, 10})) << "it has moved within this second";
}

TEST(MapWindow, DoesNotMoveBeforeItIsThere) {
  MapBench bench;
  bench.stand_on(20);
  bench.recentre();
  EXPECT_FALSE(bench.centre().has_value());
}

TEST(MapWindow, WholeNetworkIsAskedForOnceInEachTaughtRun) {
  MapBench bench;
  bench.fetch_map();
  bench.map.leave_proposals(PlaceId{bench.laid, 0}, bench.context(), bench.now);
  bench.fetch_map();
  for (const std::uint64_t run : {1U, 2U}) {
    bench.taught = ExperienceId{run};
    bench.map.leave_proposals(PlaceId{bench.laid, 0}, bench.context(), bench.now);
    bench.fetch_map();
    bench.stand_on(static_cast<std::uint32_t>(run));
    bench.recentre();
    EXPECT_FALSE(bench.centre().has_value()) << "run " << run;
    bench.fetch_map();
  }
}

TEST(MapWindow, RunThatNothingJoinsYetHasTheMapThatItLiesBeside) {
  MapBench bench(80);
  bench.taught = ExperienceId{1};
  bench.map.leave_proposals(PlaceId{bench.laid, 0}, bench.context(), bench.now);
  bench.fetch_map();
  bench.stand_on(0);
  bench.recentre();  // asks for all
  bench.map.leave_proposals(PlaceId{bench.laid, 0}, bench.context(), bench.now);
  bench.fetch_map();
  const PlaceId beside{bench.laid, 60};
  ASSERT_EQ(bench.map.window().place(beside), nullptr);
  bench.script->estimate = Estimate{{ExperienceId{1}, 3}, Relation{}, 0.0};
  bench.script->beside = beside;
  bench.now += 1s;
  bench.recentre();
  EXPECT_EQ(bench.centre(), beside);
}

TEST(MapWindow, EstimateWhosePlaceIsTakenOutIsAnchoredToWhatIsLeft) {
  MapBench bench;
  bench.fetch_map();
  bench.stand_on(20);
  EXPECT_EQ(bench.show_only(0, 15), "");
  const WindowDefinition asked = bench.map.replica().definition();
  EXPECT_FALSE(asked.centre.has_value());
  EXPECT_EQ(asked.route.front(), (PlaceId{bench.laid, 20})) << "what was around it is asked for";
  bench.now += 1s;
  EXPECT_EQ(bench.show_only(0, 15), "");
  EXPECT_EQ(bench.script->estimate->place, (PlaceId{bench.laid, 15}));
  EXPECT_EQ(bench.centre(), (PlaceId{bench.laid, 15}));
  EXPECT_TRUE(bench.map.replica().definition().route.empty());
}

TEST(MapWindow, EstimateWithNothingLeftAroundItIsGivenUp) {
  MapBench bench;
  bench.fetch_map();
  bench.stand_on(20);
  bench.show_only(1, 0);
  bench.now += 1s;
  EXPECT_NE(bench.show_only(1, 0).find("was taken out of the map"), std::string::npos);
  EXPECT_FALSE(bench.script->estimate.has_value());
}

TEST(MapWindow, WindowThatMovesAwayOnPurposeAsksForNothing) {
  MapBench bench;
  bench.fetch_map();
  bench.stand_on(20);
  bench.goes_elsewhere = true;
  const WindowDefinition before = bench.map.replica().definition();
  bench.show_only(0, 15);
  EXPECT_EQ(bench.map.replica().definition(), before);
}

TEST(MapWindow, HoldsTheRouteAndTheProposedPlaces) {
  MapBench bench;
  bench.route = a_route(bench.laid, 3, 1);
  bench.map.hold_route(bench.context(), bench.now);
  EXPECT_EQ(bench.map.replica().definition().route, bench.route->places);
  bench.stand_on(0);
  bench.map.look_at({{bench.laid, 30}}, bench.context(), bench.now);
  EXPECT_EQ(bench.map.replica().definition().route.back(), (PlaceId{bench.laid, 30}));
  bench.map.follow_search(true, bench.context(), bench.now);
  EXPECT_EQ(bench.map.replica().definition().route, bench.route->places) << "a fix ends the search";
}

TEST(MapWindow, FixAmongProposedPlacesCentresTheUsualWindowThere) {
  MapBench bench;
  bench.map.leave_proposals(PlaceId{bench.laid, 0}, bench.context(), bench.now);
  bench.fetch_map();
  bench.map.look_at({{bench.laid, 30}}, bench.context(), bench.now);
  EXPECT_EQ(bench.map.replica().definition().hops, 3U);
  bench.script->suspected = PlaceId{bench.laid, 31};
  bench.map.follow_search(false, bench.context(), bench.now);
  EXPECT_EQ(bench.centre(), (PlaceId{bench.laid, 31})) << "around the suspected place";
  bench.stand_on(32);
  bench.map.follow_search(true, bench.context(), bench.now);
  EXPECT_EQ(bench.centre(), (PlaceId{bench.laid, 32}));
  EXPECT_EQ(bench.map.replica().definition().hops, 25U);
}

}  // namespace
}  // namespace weft::agents::test
