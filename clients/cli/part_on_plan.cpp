#include "clients/cli/part_on_plan.hpp"

namespace weft::cli {

PartOnPlan part_on_plan(const Window& network, const PoseOf& pose_of) {
  PartOnPlan part;
  part.network.revision = network.revision;
  for (const auto& [id, place] : network.places) {
    const std::optional<Pose2> pose = pose_of(id);
    if (!pose) {
      ++part.left_out;
      continue;
    }
    part.network.places.insert_or_assign(id, place);
    part.layout.drawing_from_place.emplace(id, *pose);
    part.layout.island.emplace(id, 0);
  }
  for (const auto& [id, edge] : network.edges) {
    if (part.network.places.contains(id.a)) part.network.edges.insert_or_assign(id, edge);
  }
  for (const auto& [label, place] : network.labels) {
    if (part.network.places.contains(place)) part.network.labels.emplace(label, place);
  }
  index_edges(part.network);
  part.layout.islands = 1;
  return part;
}

}  // namespace weft::cli
