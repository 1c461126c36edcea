#include <nlohmann/json.hpp>

#include "storage/formats/route_graph.hpp"

namespace weft::formats {
namespace {

using nlohmann::ordered_json;

void put(ordered_json& object, const char* key, const std::string& text) {
  if (!text.empty()) object[key] = ordered_json::parse(text);
}

ordered_json json_of(const std::vector<Eigen::Vector2d>& line) {
  ordered_json points = ordered_json::array();
  for (const Eigen::Vector2d& point : line) points.push_back({point.x(), point.y()});
  return points;
}

std::string feature(const ordered_json& properties, const char* type, const ordered_json& coordinates) {
  const ordered_json object = {
      {"type", "Feature"}, {"properties", properties}, {"geometry", {{"type", type}, {"coordinates", coordinates}}}};
  return object.dump();
}

std::string feature_of(const RouteGraph::Node& node) {
  ordered_json properties = {{"id", node.id}};
  if (!node.frame.empty()) properties["frame"] = node.frame;
  put(properties, "metadata", node.metadata);
  put(properties, "operations", node.operations);
  return feature(properties, "Point", {node.position.x(), node.position.y()});
}

std::string feature_of(const RouteGraph::Edge& edge) {
  ordered_json properties = {{"id", edge.id}, {"startid", edge.start}, {"endid", edge.end}};
  if (edge.cost.has_value()) properties["cost"] = *edge.cost;
  if (edge.overridable.has_value()) properties["overridable"] = *edge.overridable;
  put(properties, "metadata", edge.metadata);
  put(properties, "operations", edge.operations);
  ordered_json coordinates = ordered_json::array();
  for (const auto& line : edge.lines) coordinates.push_back(json_of(line));
  if (!edge.multi) coordinates = edge.lines.empty() ? ordered_json::array() : coordinates.front();
  return feature(properties, edge.multi ? "MultiLineString" : "LineString", coordinates);
}

}  // namespace

std::string route_graph_text(const RouteGraph& graph) {
  std::string text = "{\"type\":\"FeatureCollection\",\n";
  const auto member = [&text](const char* key, const ordered_json& value) {
    text += ordered_json(key).dump() + ":" + value.dump() + ",\n";
  };
  if (!graph.name.empty()) member("name", graph.name);
  if (!graph.crs.empty()) member("crs", ordered_json::parse(graph.crs));
  if (!graph.date_generated.empty()) member("date_generated", graph.date_generated);
  text += "\"features\":[";
  std::size_t count = 0;
  for (const RouteGraph::Node& node : graph.nodes) text += (count++ == 0 ? "\n" : ",\n") + feature_of(node);
  for (const RouteGraph::Edge& edge : graph.edges) text += (count++ == 0 ? "\n" : ",\n") + feature_of(edge);
  return text + "\n]}\n";
}

}  // namespace weft::formats
