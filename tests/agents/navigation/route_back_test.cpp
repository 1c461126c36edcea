#include <gtest/gtest.h>

#include <chrono>

#include "agents/navigation/follower.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr ExperienceId kStraightRun{4};
/// Places of a straight run, 0.2 m apart; a stitch joins each to the one 0.4 m behind.
constexpr std::uint32_t kStraightPlaces = 8;

PlaceId place(std::uint32_t index) {
  return {kStraightRun, index};
}

Window run() {
  Window window;
  for (std::uint32_t i = 0; i < kStraightPlaces; ++i) window.places.emplace(place(i), Place{});
  for (std::uint32_t i = 0; i + 1 < kStraightPlaces; ++i) {
    Edge edge;
    edge.id = EdgeId{place(i), place(i + 1)};
    edge.a_from_b = Metric2{{0.2, 0.0, 0.0}};
    window.edges.emplace(edge.id, edge);
  }
  index_edges(window);
  return window;
}

void lead(Route& route, std::uint32_t index, double x_m) {
  if (!route.places.empty()) route.relations.emplace_back(Metric2{{x_m, 0.0, 0.0}});
  route.places.push_back(place(index));
  route.released = static_cast<std::uint32_t>(route.places.size() - 1);
}

struct RouteBackTest : testing::Test {
  Navigated look(double x_m) {
    const std::optional<Estimate> estimate = Estimate{place(4), Metric2{{x_m, 0.0, 0.0}}};
    return follower.look({window, estimate, false, 0.0, 1s}).navigated;
  }
  Route to_the_fourth() const {
    Route route;
    for (std::uint32_t i = 0; i <= 4; ++i) lead(route, i, 0.2);
    return route;
  }

  NavigationConfig config;
  Window window = run();
  Follower follower{config};
};

TEST_F(RouteBackTest, ARouteThatGoesRoundWhereTheRobotStandsIsGivenUp) {
  Route route = to_the_fourth();
  for (int round = 0; round < 20; ++round) {
    lead(route, 2, -0.4);
    lead(route, 3, 0.2);
    lead(route, 4, 0.2);
  }
  follower.follow(route, 4);
  EXPECT_EQ(look(0.0).following, Following::stopped) << "the map may change yet";
  Navigated navigated;
  for (double stood_s = 0.0; stood_s < config.follow.give_up_s; ++stood_s) navigated = look(0.0);
  EXPECT_EQ(navigated.following, Following::failed);
  EXPECT_EQ(navigated.reason, "route_makes_no_path");
}

TEST_F(RouteBackTest, OneThatLeadsOnIsDriven) {
  Route route = to_the_fourth();
  for (std::uint32_t i = 5; i < kStraightPlaces; ++i) lead(route, i, 0.2);
  follower.follow(route, 4);
  for (int i = 0; i < 60; ++i) EXPECT_EQ(look(0.0).following, Following::driving);
}

}  // namespace
}  // namespace weft::agents
