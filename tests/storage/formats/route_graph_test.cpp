#include "storage/formats/route_graph.hpp"

#include <gtest/gtest.h>

namespace weft::formats {
namespace {

std::string collection(const std::string& features) {
  return "{\"type\": \"FeatureCollection\",\n\"features\": [\n" + features + "\n]}";
}
std::string node(int id, const std::string& more = "", const std::string& at = "[1, 2]") {
  return R"({"type": "Feature", "properties": {"id": )" + std::to_string(id) + more +
         R"(}, "geometry": {"type": "Point", "coordinates": )" + at + "}}";
}
std::string edge(const std::string& properties, const std::string& type = "LineString",
                 const std::string& coordinates = "[[1, 2], [3, 4]]") {
  return R"({"type": "Feature", "properties": {)" + properties + R"(}, "geometry": {"type": ")" + type +
         R"(", "coordinates": )" + coordinates + "}}";
}

TEST(RouteGraph, ReadsWhatNav2Writes) {
  const auto read =
      read_route_graph(collection(node(0, R"(, "frame": "map", "metadata": {"a": [1]})") + ",\n" + node(7) + ",\n" +
                                  edge(R"("id": 3, "startid": 7, "endid": 0, "cost": 2.5, "overridable": false)",
                                       "MultiLineString", "[[[1, 2], [3, 4]], []]")),
                       "g");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  const RouteGraph& graph = read->value;
  EXPECT_TRUE(read->not_understood.empty());
  ASSERT_EQ(graph.nodes.size(), 2U);
  EXPECT_EQ(graph.nodes[0].frame, "map");
  EXPECT_EQ(graph.nodes[0].metadata, R"({"a":[1]})");
  EXPECT_EQ(graph.nodes[0].position, Eigen::Vector2d(1, 2));
  ASSERT_EQ(graph.edges.size(), 1U);
  EXPECT_EQ(graph.edges[0].start, 7U);
  EXPECT_EQ(graph.edges[0].cost, 2.5);
  EXPECT_EQ(graph.edges[0].overridable, false);
  ASSERT_EQ(graph.edges[0].lines.size(), 2U);
  EXPECT_EQ(graph.edges[0].lines[0][1], Eigen::Vector2d(3, 4));
  const auto again = read_route_graph(route_graph_text(graph), "g");
  ASSERT_TRUE(again.has_value()) << again.error().message;
  EXPECT_EQ(again->value, graph);
}

TEST(RouteGraph, WhatNav2DoesNotHaveIsListedWithItsLine) {
  const auto read = read_route_graph(
      collection(node(0, R"(, "colour": 1)") + ",\n" + node(1, "", "[1, 2, 3]") + ",\n" +
                 R"({"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": []}})"),
      "g");
  ASSERT_TRUE(read.has_value()) << read.error().message;
  EXPECT_EQ(read->not_understood, (std::vector<NotUnderstood>{{"node property colour", 3, 1},
                                                              {"a coordinate's third number", 4, 1},
                                                              {"geometry 'Polygon'", 5, 1}}));
}

TEST(RouteGraph, WhatIsWrongIsSaidWithItsLine) {
  const std::string nodes = node(0) + ",\n" + node(1) + ",\n";
  const std::vector<std::pair<std::string, std::string>> table = {
      {"[]", "g:1: a route graph is a GeoJSON FeatureCollection with 'features'"},
      {collection(node(-1)), "g:3: id must be a whole number from 0"},
      {collection(nodes + node(1)), "g:5: node 1 stands there a second time"},
      {collection(nodes + "{}"), "g:5: a feature has the type Feature, a geometry and properties"},
      {collection(nodes + "3"), "g:5: a feature has the type Feature, a geometry and properties"},
      {collection(node(0, "", "[1]")), "g:3: a coordinate must be [x, y] in metres"},
      {collection(node(0, "", R"(["a", 2])")), "g:3: x must be a finite number"},
      {collection(node(0, R"(, "frame": 3)")), "g:3: frame must be a text"},
      {collection(nodes + edge(R"("id": 3, "startid": 0)")), "g:5: endid must be a whole number from 0"},
      {collection(nodes + edge(R"("id": 3, "startid": 0, "endid": 9)")),
       "g:5: edge 3 leads to node 9, which does not exist"},
      {collection(nodes + edge(R"("id": 3, "startid": 0, "endid": 1, "cost": "high")")),
       "g:5: cost must be a finite number"},
      {collection(nodes + edge(R"("id": 3, "startid": 0, "endid": 1, "overridable": 1)")),
       "g:5: overridable must be true or false"},
      {collection(nodes + edge(R"("id": 3, "startid": 0, "endid": 1)", "LineString", "7")),
       "g:5: a line must be a list of [x, y]"},
      {collection(nodes + edge(R"("id": 3, "startid": 0, "endid": 1)", "MultiLineString", "7")),
       "g:5: coordinates must be a list of lines"}};
  for (const auto& [text, message] : table) {
    const auto read = read_route_graph(text, "g");
    ASSERT_FALSE(read.has_value()) << message;
    EXPECT_EQ(read.error().message, message);
  }
}

TEST(RouteGraph, BrokenAndBottomlessJsonIsSaidWithItsLine) {
  const auto broken = read_route_graph("{\"type\":\n\"FeatureCollection\",\n,}", "g");
  ASSERT_FALSE(broken.has_value());
  EXPECT_EQ(broken.error().message.rfind("g:3: no JSON: ", 0), 0U) << broken.error().message;
  const std::string deep(100'000, '[');
  const auto bottomless =
      read_route_graph(collection(node(0, ", \"metadata\": " + deep + std::string(deep.size(), ']'))), "g");
  ASSERT_FALSE(bottomless.has_value());
  EXPECT_EQ(bottomless.error().message, "g:3: nested deeper than 64 levels");
}

}  // namespace
}  // namespace weft::formats
