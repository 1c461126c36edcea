#pragma once
#include <map>
#include <string>

#include "core/network/window.hpp"
#include "storage/formats/pose_graph.hpp"
#include "storage/formats/route_graph.hpp"
#include "storage/formats/trajectory.hpp"

namespace weft::formats {

/// Gives the pose of each place in one frame: a drawing's or a site's, in metres. The network itself has none.
using Poses = std::map<PlaceId, Pose2>;

/// Returns a pose graph: estimates from `frame_from_place`, edges with the inverse of their covariances; spatial if
/// one relation is, planar otherwise. Keys are GTSAM's symbols, a letter an experience, up to 52 experiences; counted
/// from 0 beyond. Notes keep place ids, labels, and what stitches are (docs/formats/open.md). A variance below 1e-12
/// is written as 1e-12, because its inverse is none. not_found: a place without a pose.
Result<PoseGraph> pose_graph_of(const Window& network, const Poses& frame_from_place);

/// Returns a route graph: a node a place, an edge for each direction in which one can be driven; its cost is the
/// length in metres. Place, heading and labels stand in the nodes' metadata. not_found: a place without a pose.
Result<RouteGraph> route_graph_of(const Window& network, const Poses& frame_from_place);

/// Returns the poses of one experience's places at the sensor times of their robot. not_found: no such experience, a
/// place without a pose; invalid: times that do not increase, as with imported places, which have none.
Result<Trajectory> trajectory_of(const Window& network, const Poses& frame_from_place, ExperienceId experience);

/// Returns the network for Graphviz: places as nodes (labels, experience; `pos` in metres where there is a pose),
/// edges with origin, relation, method, and arrowheads in the directions in which they can be driven.
std::string dot_text(const Window& network, const Poses& frame_from_place);

/// Returns the same for yEd, Gephi, NetworkX, igraph: GraphML 1.0, each attribute declared with its type.
std::string graphml_text(const Window& network, const Poses& frame_from_place);

}  // namespace weft::formats
