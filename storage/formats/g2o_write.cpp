#include "storage/formats/g2o.hpp"
#include "storage/formats/lines.hpp"

namespace weft::formats {
namespace {

void add(std::string& text, double value) {
  text += ' ';
  text += text_of(value);
}

void add(std::string& text, const Pose2& pose) {
  for (const double value : {pose.x, pose.y, pose.heading}) add(text, value);
}

void add(std::string& text, const Pose3& pose) {
  for (const double value : pose.translation) add(text, value);
  for (const double value : pose.rotation.coeffs()) add(text, value);  // Eigen keeps x, y, z, w
}

template <int N>
void add(std::string& text, const Eigen::Matrix<double, N, N>& information) {
  for (int row = 0; row < N; ++row) {
    for (int column = row; column < N; ++column) add(text, information(row, column));
  }
}

}  // namespace

std::string g2o_text(const PoseGraph& graph) {
  std::string text;
  for (const std::string& note : graph.notes) text += "# weft " + note + "\n";
  for (const PoseGraph::Vertex& vertex : graph.vertices) {
    text += std::holds_alternative<Pose2>(vertex.estimate) ? "VERTEX_SE2 " : "VERTEX_SE3:QUAT ";
    text += std::to_string(vertex.key);
    std::visit([&](const auto& pose) { add(text, pose); }, vertex.estimate);
    text += '\n';
  }
  for (const std::uint64_t key : graph.fixed) text += "FIX " + std::to_string(key) + "\n";
  for (const PoseGraph::Edge& edge : graph.edges) {
    text += std::holds_alternative<PlanarMeasurement>(edge.seen) ? "EDGE_SE2 " : "EDGE_SE3:QUAT ";
    text += std::to_string(edge.a) + " " + std::to_string(edge.b);
    std::visit(
        [&](const auto& seen) {
          add(text, seen.a_from_b);
          add(text, seen.information);
        },
        edge.seen);
    text += '\n';
  }
  return text;
}

}  // namespace weft::formats
