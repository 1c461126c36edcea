#include <nlohmann/json.hpp>

#include "storage/formats/network_export.hpp"
#include "storage/formats/relation_text.hpp"

namespace weft::formats {

Result<RouteGraph> route_graph_of(const Window& network, const Poses& frame_from_place) {
  const std::map<PlaceId, std::string> labels = labels_by_place(network);
  RouteGraph graph;
  graph.name = "weft revision " + std::to_string(network.revision.value);
  std::map<PlaceId, std::uint64_t> ids;
  for (const auto& [place, held] : network.places) {
    const auto pose = frame_from_place.find(place);
    if (pose == frame_from_place.end()) {
      return fail(ErrorCode::not_found, "place " + to_string(place) + " has no pose in the frame of the export");
    }
    nlohmann::json metadata = {{"place", to_string(place)}, {"heading", pose->second.heading}};
    if (const auto label = labels.find(place); label != labels.end()) metadata["labels"] = label->second;
    RouteGraph::Node node;
    node.id = ids.size();
    node.position = pose->second.translation();
    node.frame = "map";
    node.metadata = metadata.dump();
    ids.emplace(place, node.id);
    graph.nodes.push_back(std::move(node));
  }
  // Nav2 wants the ids of edges apart from those of nodes.
  std::uint64_t next = ids.size();
  const auto add = [&](const PlaceId& from, const PlaceId& to, const Edge& edge) {
    RouteGraph::Edge route;
    route.id = next++;
    route.start = ids.at(from);
    route.end = ids.at(to);
    route.cost = distance_m(edge.a_from_b);
    route.metadata = nlohmann::json{{"origin", to_string(edge.origin)}, {"method", edge.method}}.dump();
    route.lines = {{graph.nodes[route.start].position, graph.nodes[route.end].position}};
    graph.edges.push_back(std::move(route));
  };
  for (const auto& [id, edge] : network.edges) {
    if (edge.drivable == Drivable::a_to_b || edge.drivable == Drivable::both) add(id.a, id.b, edge);
    if (edge.drivable == Drivable::b_to_a || edge.drivable == Drivable::both) add(id.b, id.a, edge);
  }
  return graph;
}

}  // namespace weft::formats
