#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "core/geometry/pose3.hpp"
#include "core/result.hpp"

namespace weft::formats {

/// Holds the pose that a graph gives a vertex to begin with: in the file's own frame, metres and radians.
using Estimate = std::variant<Pose2, Pose3>;

/// Holds the measurement of one edge. The information is the inverse covariance of xi in a_from_b * exp(xi), as in
/// core's Metric2 and Metric3: order (x, y, heading), or (translation, rotation vector).
struct PlanarMeasurement {
  Pose2 a_from_b;
  Eigen::Matrix3d information = Eigen::Matrix3d::Identity();
};
struct SpatialMeasurement {
  Pose3 a_from_b;
  Matrix6d information = Matrix6d::Identity();
};
using Measurement = std::variant<PlanarMeasurement, SpatialMeasurement>;

/// Holds a pose graph as files do. All of it is planar, or all of it is spatial. Vertices may be missing: some files
/// have edges only, and those of one robot of several name vertices of the others.
struct PoseGraph {
  struct Vertex {
    std::uint64_t key = 0;
    Estimate estimate;
  };
  struct Edge {
    std::uint64_t a = 0;
    std::uint64_t b = 0;
    Measurement seen;
  };
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  std::vector<std::uint64_t> fixed;  ///< vertices that an optimiser shall not move
  std::vector<std::string> notes;    ///< comments of ours, without "# weft "
};

/// Returns the robot whose vertex it is, as in GTSAM's symbols: a letter in the key's highest byte. 0: none.
char robot_of(std::uint64_t key);

/// Joins several files of one graph: an edge that stands in two of them, with the same numbers, is there once.
/// conflict: a vertex is declared twice with different estimates; planar and spatial graphs are mixed.
Result<PoseGraph> join(const std::vector<PoseGraph>& graphs);

/// Returns whether both have bit for bit the same numbers in the same order.
bool identical(const PoseGraph& first, const PoseGraph& second);

}  // namespace weft::formats
