#pragma once
#include <array>
#include <vector>

#include "agents/control/grid/occupancy_grid.hpp"
#include "clients/evaluate/topometric/moment.hpp"
#include "clients/evaluate/topometric/true_hall.hpp"

/// Makes the points that the study's pictures show; site frame, metres.
namespace weft::evaluate::topometric {

using Points = std::vector<std::array<double, 2>>;

/// Returns where the robot truly was, each 5 cm or so.
Points path_of(const Moments& moments);
/// Returns where a chain of odometry would have it, laid over the truth at its first moment.
Points path_of(const Moments& moments, Pose2 Moment::*chain);
/// Returns where it believed to be.
Points believed_path_of(const Moments& moments, const TruePlaces& places);
/// Returns corners of what stands there, five points each (the first again), then a point that is none (NaN).
Points outlines_of(const TrueHall& hall);
/// Returns the middles of occupied cells.
Points occupied_of(const agents::OccupancyGrid& grid, const Pose2& site_from_grid);
/// Returns values over the seconds of a ride, each second.
Points over_time(const Moments& moments, const std::vector<double>& values);

}  // namespace weft::evaluate::topometric
