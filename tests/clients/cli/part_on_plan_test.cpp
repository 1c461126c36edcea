#include "clients/cli/part_on_plan.hpp"

#include <gtest/gtest.h>

#include "core/network/change.hpp"
#include "tests/clients/cli/fleet.hpp"

namespace weft::cli::test {
namespace {

TEST(PartOnPlan, HasThePlacesWithAPoseTheirEdgesAndTheirLabels) {
  std::vector<Batch> batches = two_loops({0xA1}, {0xB2}, {}, {});
  std::erase_if(batches.back().edges, [](const Edge& edge) { return edge.origin == Origin::stitch; });
  Snapshot map;
  for (const Batch& batch : batches) map = with(map, batch);
  map = with_label(map, "here", {{0xA1}, 3});
  map = with_label(map, "elsewhere", {{0xB2}, 3});
  const Window network = make_window(map, WindowDefinition{});
  const PartOnPlan part = part_on_plan(network, [](const PlaceId& place) {
    return place.experience == ExperienceId{0xA1} ? std::optional(Pose2{1.0 * place.index, 2.0, 0.5}) : std::nullopt;
  });
  EXPECT_EQ(part.network.revision, network.revision);
  EXPECT_EQ(part.network.places.size(), batches.front().places.size());
  EXPECT_EQ(part.left_out, batches.back().places.size());
  EXPECT_EQ(part.network.edges.size(), batches.front().edges.size());
  EXPECT_TRUE(part.network.labels.contains("here"));
  EXPECT_FALSE(part.network.labels.contains("elsewhere"));
  EXPECT_EQ(part.layout.drawing_from_place.at({{0xA1}, 7}), (Pose2{7.0, 2.0, 0.5}));
  EXPECT_EQ(part.layout.islands, 1U);
  std::size_t ends = 0;
  part.network.for_each_edge({{0xA1}, 7}, [&](const Edge&) { ++ends; });
  EXPECT_EQ(ends, 2U) << "edges are found from their ends";
}

}  // namespace
}  // namespace weft::cli::test
