#pragma once
#include <vector>

#include "agents/control/grid/occupancy_grid.hpp"
#include "agents/perception/particles/likelihood_field.hpp"
#include "agents/perception/particles/resampling.hpp"
#include "agents/perception/scan.hpp"
#include "clients/evaluate/particles/carmen_log.hpp"
#include "core/result.hpp"

namespace weft::evaluate::particles {

/// Bounds the ranges that are used, of map and scans alike.
inline constexpr double kRangeM = 30.0;
/// Is the standard deviation of a laser's range.
inline constexpr double kLaserSigmaM = 0.02;

/// Makes a grid of the scans with even numbers, at the poses that the log has, by the product's rays.
/// exhausted: the poses are so far apart that the grid would have more than 64 million cells.
Result<agents::OccupancyGrid> grid_of_even_scans(const std::vector<LaserScan>& scans);

/// Returns the field in which scans are weighed.
agents::LikelihoodField field_of(const agents::OccupancyGrid& grid, const agents::LikelihoodConfig& config);

/// Draws poses above the cells that are known to be free, all headings alike. At least one cell is free.
agents::DrawPose anywhere_free(const agents::OccupancyGrid& grid);

/// Returns a scan as the product has it, the laser's frame being the robot's.
agents::Scan scan_of_laser(const LaserScan& scan);

}  // namespace weft::evaluate::particles
