#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "storage/formats/not_understood.hpp"

namespace weft::formats {

/// Holds a route graph of Nav2's route server, as its GeoJSON file does. What the route server hands on unread
/// (metadata, operations, the coordinate system) is kept as JSON text; empty: not there.
struct RouteGraph {
  struct Node {
    std::uint64_t id = 0;
    Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< metres in `frame`
    std::string frame;                                   ///< empty: the route server's own
    std::string metadata;
    std::string operations;
    bool operator==(const Node&) const = default;
  };
  /// Describes a directed edge.
  struct Edge {
    std::uint64_t id = 0;
    std::uint64_t start = 0;
    std::uint64_t end = 0;
    std::optional<double> cost;
    std::optional<bool> overridable;  ///< whether a scorer may replace the cost
    std::string metadata;
    std::string operations;
    bool multi = false;                               ///< a MultiLineString
    std::vector<std::vector<Eigen::Vector2d>> lines;  ///< for drawing only: Nav2 drives from node to node
    bool operator==(const Edge&) const = default;
  };
  std::string name;
  std::string crs;
  std::string date_generated;
  std::vector<Node> nodes;
  std::vector<Edge> edges;
  bool operator==(const RouteGraph&) const = default;
};

/// Reads a route graph. Lists members that Nav2's format does not have, heights, and edges with the id of an earlier
/// one (they are kept).
/// invalid, with file and line of the feature: no JSON, a member of the wrong type, a node that stands there twice,
/// an edge to a node that does not exist, coordinates that are no finite numbers.
Result<Read<RouteGraph>> read_route_graph(std::string_view text, std::string_view file);

/// Writes a feature a line. Reads back equal.
std::string route_graph_text(const RouteGraph& graph);

}  // namespace weft::formats
