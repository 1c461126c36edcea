#pragma once
#include <string>
#include <string_view>

#include "storage/formats/not_understood.hpp"
#include "storage/formats/pose_graph.hpp"

namespace weft::formats {

/// Reads VERTEX_SE2, VERTEX_SE3:QUAT, EDGE_SE2, EDGE_SE3:QUAT and FIX; other tags are listed. A file without any
/// vertex is a graph of edges. In one with vertices an edge may lead to an undeclared one only when its key is
/// another robot's (`robot_of`): that stands in another file. Other edges to vertices that are not there, and FIX of
/// such a one or of a landmark, are left out and listed. invalid, with file and line: a wrong count of numbers, one
/// that is not finite, a quaternion that is not unit within 1e-3 (taken ones are normalised), information that is not
/// positive definite, a vertex that is declared twice, an edge from a vertex to itself, planar and spatial in one
/// file.
Result<Read<PoseGraph>> read_g2o(std::string_view text, std::string_view file);

/// Reads back as an identical graph.
std::string g2o_text(const PoseGraph& graph);

}  // namespace weft::formats
