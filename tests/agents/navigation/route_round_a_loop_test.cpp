#include <gtest/gtest.h>

#include "agents/navigation/route_ahead.hpp"

namespace weft::agents {
namespace {

constexpr ExperienceId kLoop{3};
constexpr std::uint32_t kLoopPlaces = 40;  // of a loop, 0.2 m apart; the last one is joined to the first

PlaceId place_of_loop(std::uint32_t index) {
  return {kLoop, index};
}

/// Returns a way of 8 m that no poses are known of, closed by a stitch.
Window loop() {
  Window window;
  for (std::uint32_t i = 0; i < kLoopPlaces; ++i) window.places.emplace(place_of_loop(i), Place{});
  for (std::uint32_t i = 0; i < kLoopPlaces; ++i) {
    Edge edge;
    edge.id = i + 1 < kLoopPlaces ? EdgeId{place_of_loop(i), place_of_loop(i + 1)}
                                  : EdgeId{place_of_loop(0), place_of_loop(i)};
    edge.a_from_b = AlongPath{i + 1 < kLoopPlaces ? 0.2 : -0.2};
    window.edges.emplace(edge.id, edge);
  }
  index_edges(window);
  return window;
}

Route rounds(std::uint32_t count) {
  Route route;
  for (std::uint32_t i = 0; i < count * kLoopPlaces; ++i) {
    route.places.push_back(place_of_loop(i % kLoopPlaces));
    route.relations.emplace_back(AlongPath{0.2});
  }
  route.relations.pop_back();
  route.released = static_cast<std::uint32_t>(route.places.size() - 1);
  return route;
}

std::uint32_t index_at(const Estimate& estimate, std::uint32_t from) {
  const std::optional<Joint> found = joint(NavigationConfig{}, loop(), rounds(3), estimate, from);
  EXPECT_TRUE(found);
  return found ? found->index : 999;
}

TEST(RouteRoundALoop, APlaceIsTheOneOfThisRound) {
  EXPECT_EQ(index_at({place_of_loop(5), AlongPath{}}, 0), 5U);
  EXPECT_EQ(index_at({place_of_loop(5), AlongPath{}}, 42), 45U);
  EXPECT_EQ(index_at({place_of_loop(38), AlongPath{}}, 80), 78U);
}

TEST(RouteRoundALoop, JustBeforeTheBeginningItIsNotAtTheEnd) {
  // The loop's last place is 0.2 m before its first one, and 39 places further on along the route.
  EXPECT_LE(index_at({place_of_loop(39), AlongPath{0.05}}, 0), 2U);
}

TEST(RouteRoundALoop, ARobotThatIsFarFromTheBeginningIsWhereItIs) {
  EXPECT_EQ(index_at({place_of_loop(20), AlongPath{}}, 0), 20U);
}

}  // namespace
}  // namespace weft::agents
