#include "storage/formats/pose_graph.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <utility>

namespace weft::formats {
namespace {

bool same(const Pose3& first, const Pose3& second) {
  return first.rotation.coeffs() == second.rotation.coeffs() && first.translation == second.translation;
}
bool same(const Pose2& first, const Pose2& second) {
  return first == second;
}

bool same(const Estimate& first, const Estimate& second) {
  if (first.index() != second.index()) return false;
  return std::visit([&](const auto& pose) { return same(pose, std::get<std::decay_t<decltype(pose)>>(second)); },
                    first);
}

bool same(const PoseGraph::Edge& first, const PoseGraph::Edge& second) {
  if (first.a != second.a || first.b != second.b || first.seen.index() != second.seen.index()) return false;
  return std::visit(
      [&](const auto& one) {
        const auto& other = std::get<std::decay_t<decltype(one)>>(second.seen);
        return same(one.a_from_b, other.a_from_b) && one.information == other.information;
      },
      first.seen);
}

/// Returns 0 for a planar graph, 1 for a spatial one; none for a graph without anything.
std::optional<std::size_t> kind_of(const PoseGraph& graph) {
  if (!graph.vertices.empty()) return graph.vertices.front().estimate.index();
  if (!graph.edges.empty()) return graph.edges.front().seen.index();
  return std::nullopt;
}

}  // namespace

char robot_of(std::uint64_t key) {
  const auto letter = static_cast<unsigned char>(key >> 56U);
  return std::isalpha(letter) != 0 ? static_cast<char>(letter) : '\0';
}

Result<PoseGraph> join(const std::vector<PoseGraph>& graphs) {
  PoseGraph all;
  std::map<std::uint64_t, Estimate> estimates;
  std::multimap<std::pair<std::uint64_t, std::uint64_t>, std::size_t> edges;
  for (const PoseGraph& graph : graphs) {
    const std::optional<std::size_t> kind = kind_of(graph);
    if (kind.has_value() && kind_of(all).value_or(*kind) != *kind) {
      return fail(ErrorCode::conflict, "one graph is planar, another spatial: they cannot be joined");
    }
    for (const PoseGraph::Vertex& vertex : graph.vertices) {
      const auto [known, is_new] = estimates.emplace(vertex.key, vertex.estimate);
      if (is_new) {
        all.vertices.push_back(vertex);
      } else if (!same(known->second, vertex.estimate)) {
        return fail(ErrorCode::conflict,
                    "vertex " + std::to_string(vertex.key) + " stands in two graphs with different estimates");
      }
    }
    for (const PoseGraph::Edge& edge : graph.edges) {
      const auto [first, last] = edges.equal_range({edge.a, edge.b});
      if (std::any_of(first, last, [&](const auto& known) { return same(all.edges[known.second], edge); })) continue;
      edges.emplace(std::pair{edge.a, edge.b}, all.edges.size());
      all.edges.push_back(edge);
    }
    for (const std::uint64_t key : graph.fixed) {
      if (std::find(all.fixed.begin(), all.fixed.end(), key) == all.fixed.end()) all.fixed.push_back(key);
    }
    all.notes.insert(all.notes.end(), graph.notes.begin(), graph.notes.end());
  }
  return all;
}

bool identical(const PoseGraph& first, const PoseGraph& second) {
  return first.fixed == second.fixed && first.notes == second.notes &&
         std::equal(first.vertices.begin(), first.vertices.end(), second.vertices.begin(), second.vertices.end(),
                    [](const auto& one, const auto& other) {
                      return one.key == other.key && same(one.estimate, other.estimate);
                    }) &&
         std::equal(first.edges.begin(), first.edges.end(), second.edges.begin(), second.edges.end(),
                    [](const auto& one, const auto& other) { return same(one, other); });
}

}  // namespace weft::formats
