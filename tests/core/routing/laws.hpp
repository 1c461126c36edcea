#pragma once
#include <gtest/gtest.h>

#include "core/network/routing/routing.hpp"
#include "tests/support/network_maker.hpp"

namespace weft::routing {

inline double cost(const Path& path) {
  double sum = 0.0;
  for (const Relation& relation : path.relations) sum += norm(relation);
  return sum;
}

/// Expects that the path can be driven, edge by edge.
inline void expect_drivable(const Snapshot& snapshot, const Path& path, const std::set<std::string>& methods) {
  ASSERT_EQ(path.relations.size() + 1, path.places.size());
  double length_m = 0.0;
  for (std::size_t at = 0; at + 1 < path.places.size(); ++at) {
    const PlaceId& here = path.places[at];
    bool is_there = false;
    snapshot.for_each_edge(here, [&](const Edge& edge) {
      is_there =
          is_there || (other_end(edge, here) == path.places[at + 1] && can_drive(edge, here) &&
                       methods.contains(edge.method) && identical(relation_from(edge, here), path.relations[at]));
    });
    EXPECT_TRUE(is_there) << to_string(here) << " to " << to_string(path.places[at + 1]);
    length_m += distance_m(path.relations[at]);
  }
  EXPECT_NEAR(path.length_m, length_m, 1e-9);
}

/// Expects what Dijkstra says, at the same cost or in the same words: the law of all this. Returns how many it found.
inline std::size_t expect_as_dijkstra(Random& random, const Preparation& preparation, const Snapshot& snapshot,
                                      std::size_t pairs) {
  const std::set<std::string>& methods = preparation.methods;
  std::size_t found = 0;
  for (std::size_t i = 0; i < pairs; ++i) {
    const PlaceId from = support::pick_place(random, snapshot);
    const PlaceId to = support::pick_place(random, snapshot);
    const Result<Path> wanted = weft::shortest_path(snapshot, from, to, methods);
    const Result<Path> got = shortest_path(preparation, snapshot, from, to, methods);
    EXPECT_EQ(wanted.has_value(), got.has_value()) << to_string(from) << " to " << to_string(to);
    if (wanted.has_value() != got.has_value()) continue;
    if (!wanted) {
      EXPECT_EQ(wanted.error().message, got.error().message);
      continue;
    }
    ++found;
    EXPECT_NEAR(cost(*wanted), cost(*got), 1e-9 * (1.0 + cost(*wanted)))
        << to_string(from) << " to " << to_string(to);
    EXPECT_EQ(got->places.front(), from);
    EXPECT_EQ(got->places.back(), to);
    expect_drivable(snapshot, *got, methods);
  }
  return found;
}

}  // namespace weft::routing
