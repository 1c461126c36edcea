#pragma once
#include <functional>
#include <optional>

#include "clients/cli/layout.hpp"

namespace weft::cli {

/// Holds the part of a network that has a place on a floor plan, or in another frame of a site.
struct PartOnPlan {
  Window network;
  Layout layout;             ///< in that frame
  std::size_t left_out = 0;  ///< places that have none in it
};

/// Returns a place's pose in the frame; none: the place lies in a part that nothing holds there. All places of a part
/// have one, or none has.
using PoseOf = std::function<std::optional<Pose2>(const PlaceId&)>;

/// Returns the part of the network whose places have a pose, with its edges and labels.
PartOnPlan part_on_plan(const Window& network, const PoseOf& pose_of);

}  // namespace weft::cli
