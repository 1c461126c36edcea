#include "core/network/part_layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <ranges>

#include "core/network/change.hpp"

namespace weft {
namespace {

constexpr std::uint64_t kLastOfFan = 8;

PlaceId place_of_fan(std::uint64_t number) {
  return {{number}, 0};
}

/// Makes a map with six ways from its first place to its last one that leave the same variance and do not agree.
Snapshot fan() {
  Snapshot map;
  for (std::uint64_t number = 1; number <= kLastOfFan; ++number) {
    Batch batch;
    batch.experience = {number};
    batch.sequence = 1;
    Place place;
    place.id = place_of_fan(number);
    batch.places.push_back(place);
    const auto join = [&](std::uint64_t other, const Pose2& other_from_here) {
      Edge edge;
      edge.id = {place_of_fan(other), place.id};
      edge.origin = Origin::stitch;
      edge.a_from_b = Metric2{other_from_here, 1e-4 * Eigen::Matrix3d::Identity()};
      batch.edges.push_back(edge);
    };
    if (number > 1 && number < kLastOfFan) join(1, {1.0, static_cast<double>(number), 0.0});
    for (std::uint64_t other = 2; number == kLastOfFan && other < number; ++other) join(other, {1.0, 0.0, 0.0});
    map = with(map, batch);
  }
  return map;
}

/// Returns a view that visits the edges at each place the other way round.
NetworkView backwards(NetworkView view) {
  const auto forwards = view.for_each_edge;
  view.for_each_edge = [forwards](const PlaceId& place, const NetworkView::Visit& visit) {
    std::vector<Edge> edges;
    forwards(place, [&](const Edge& edge) { edges.push_back(edge); });
    std::ranges::for_each(edges | std::views::reverse, visit);
  };
  return view;
}

Pose2 last_of_fan(NetworkView view) {
  PartLayout layout(std::move(view), place_of_fan(1));
  while (layout.step(1)) {
  }
  return *layout.root_from_place().find(place_of_fan(kLastOfFan));
}

/// Returns a view of so many places of one run, each of which is joined to all others.
NetworkView all_joined(std::uint32_t places) {
  return {[places](const PlaceId& place) { return place.index < places; },
          [places](const PlaceId& place, const NetworkView::Visit& visit) {
            for (std::uint32_t other = 0; other < places; ++other) {
              if (other == place.index) continue;
              Edge edge;
              edge.id = {{{1}, std::min(other, place.index)}, {{1}, std::max(other, place.index)}};
              edge.a_from_b = Metric2{{}, Eigen::Matrix3d::Identity()};
              visit(edge);
            }
          }};
}

TEST(PartLayout, OfWaysThatLeaveTheSameVarianceTakesTheOneOverTheLowestPlaceWhateverTheOrderOfEdges) {
  const auto map = std::make_shared<const Snapshot>(fan());
  const Window window = make_window(*map, WindowDefinition{});
  const Pose2 over_the_lowest{2.0, 2.0, 0.0};
  EXPECT_EQ(last_of_fan(view_of(map)), over_the_lowest);
  EXPECT_EQ(last_of_fan(view_of(window)), over_the_lowest);
  EXPECT_EQ(last_of_fan(backwards(view_of(map))), over_the_lowest);
  EXPECT_EQ(last_of_fan(backwards(view_of(window))), over_the_lowest);
}

TEST(PartLayout, CountsWaysToPlacesThatAreLaidAlreadyToo) {
  constexpr std::uint32_t kPlaces = 40;
  PartLayout layout(all_joined(kPlaces), {{1}, 0});
  std::size_t steps = 0;
  while (layout.step(kPlaces)) ++steps;
  EXPECT_EQ(layout.root_from_place().size(), kPlaces);
  EXPECT_GE(steps, (kPlaces - 1) / 2 - 1) << "there are 780 ways, and 40 a step";
}

}  // namespace
}  // namespace weft
