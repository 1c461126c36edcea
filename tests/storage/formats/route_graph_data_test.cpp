#include <gtest/gtest.h>

#include "storage/formats/route_graph.hpp"
#include "tests/storage/formats/data_files.hpp"

namespace weft::formats::test {
namespace {

std::size_t times(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

TEST(RouteGraphFiles, EachIsReadWholeAndWrittenTheSame) {
  const auto data = data_folder();
  if (!data || !std::filesystem::is_directory(*data / "ros-maps")) GTEST_SKIP() << no_data("route graphs");
  const auto files = files_that_end(*data / "ros-maps", ".geojson");
  ASSERT_EQ(files.size(), 7U);
  for (const auto& file : files) {
    const std::string text = read_text(file);
    const auto graph = read_route_graph(text, file.string());
    ASSERT_TRUE(graph.has_value()) << graph.error().message;
    // The depot's graph, which comes twice, names six edges as earlier ones.
    const bool depot = graph->value.name == "depot_graph" || graph->value.name == "turtlebot4_graph";
    ASSERT_EQ(graph->not_understood.size(), depot ? 1U : 0U) << file;
    for (const NotUnderstood& part : graph->not_understood) {
      EXPECT_EQ(to_string(part, "f"), "f:47: an edge with the id of an earlier one, 6 times");
    }
    EXPECT_EQ(graph->value.nodes.size(), times(text, "\"Point\"")) << file;
    EXPECT_EQ(graph->value.edges.size(), times(text, "LineString\"")) << file;
    EXPECT_FALSE(graph->value.crs.empty());
    const auto again = read_route_graph(route_graph_text(graph->value), "written");
    ASSERT_TRUE(again.has_value()) << again.error().message;
    EXPECT_EQ(again->value, graph->value) << file;
  }
}

TEST(RouteGraphFiles, TheSampleKeepsMetadataAndOperations) {
  const auto data = data_folder();
  const std::string name = "ros-maps/nav2_route_graphs/sample_graph.geojson";
  if (!data || !std::filesystem::exists(*data / name)) GTEST_SKIP() << no_data(name);
  const auto graph = read_route_graph(read_text(*data / name), name);
  ASSERT_TRUE(graph.has_value()) << graph.error().message;
  const RouteGraph::Node& node = graph->value.nodes.at(0);
  EXPECT_EQ(node.frame, "map");
  EXPECT_NE(node.metadata.find("\"living_room\""), std::string::npos);
  EXPECT_EQ(node.operations, R"({"stop":{"metadata":{"wait_for":5.0},"trigger":"NODE","type":"stop"}})");
  std::size_t costed = 0;
  for (const RouteGraph::Edge& edge : graph->value.edges) costed += edge.cost.has_value() ? 1 : 0;
  EXPECT_EQ(costed, 1U);
}

}  // namespace
}  // namespace weft::formats::test
