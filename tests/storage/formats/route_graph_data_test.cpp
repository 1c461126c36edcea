#include <gtest/gtest.h>

#include "storage/formats/route_graph.hpp"
#include "tests/storage/formats/data_files.hpp"

namespace weft::formats::test {
namespace {

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

/// Returns what a file has wrong: six edges of the depot's, which comes twice, repeat ids; one line of AWS's is no
/// line.
std::vector<std::string> not_understood(const std::string& file) {
  if (file == "depot_graph.geojson" || file == "turtlebot4_graph.geojson") {
    return {file + ":47: an edge with the id of an earlier one, 6 times"};
  }
  if (file == "aws_graph.geojson") {
    return {file + ":130: a LineString with the coordinates of a MultiLineString, once"};
  }
  return {};
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
    std::vector<std::string> said;
    for (const NotUnderstood& part : graph->not_understood) said.push_back(to_string(part, file.filename().string()));
    EXPECT_EQ(said, not_understood(file.filename().string())) << file;
    EXPECT_EQ(graph->value.nodes.size(), count_of(text, "\"Point\"")) << file;
    EXPECT_EQ(graph->value.edges.size(), count_of(text, "LineString\"")) << file;
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
