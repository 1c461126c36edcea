#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "agents/perception/clouds/cell_table.hpp"
#include "agents/perception/clouds/framed_cloud.hpp"

namespace weft::agents {

/// Describes how the points in each cell of a cloud become a normal distribution.
struct NdtCellConfig {
  double finest_m = 0.2;         ///< edge of the smallest cells; each level above has them twice as large
  std::size_t levels = 3;        ///< used at once
  double least_points = 5.0;     ///< of a cell; fewer say nothing of a surface
  double least_sigma_m = 0.015;  ///< of a surface: quantum, calibration, what is not plane
  double thickest = 0.6;    ///< most depth noise of a cell, in its edges: a cell cuts a thicker surface in slices
  double tilt_share = 0.2;  ///< variance of a surface's tilt, in its variance across by that along
};

/// Holds the normal distribution of the points in one cell, and the surface without an end that it is matched to as.
struct NdtCell {
  Eigen::Vector3d mean;
  Eigen::Matrix3d covariance;       ///< of the points, at least as wide as depth is noisy
  Eigen::Vector3d normal;           ///< of the surface: the direction in which the points spread least
  double across = 0.0;              ///< variance across the surface, m^2
  Eigen::Matrix3d mean_covariance;  ///< of the mean itself
  bool is_finest = true;            ///< no smaller cells hold its points
};

/// Holds all cells of one size that have enough points.
struct NdtLevel {
  double cell_m = 0.0;
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< corner of cell 0, 0, 0
  CellTable table;
  std::vector<NdtCell> cells;  ///< by the table's numbers
};

/// Holds a cloud as normal distributions (NDT) in cells of several sizes, the finest first: what is matched of it.
struct NdtMap {
  std::vector<NdtLevel> levels;
};

/// Makes the cells of a cloud. Each covariance is widened along the ray from the camera to at least the depth noise
/// there. Where a cell cuts a surface says nothing of where the surface is, so it is matched to as one without an
/// end. Where points are too few or too noisy for the smaller cells, larger ones are `is_finest`. A cloud too sparse
/// for the finest cells (less than half of its points in cells with enough of them) begins with larger ones. A floor
/// at z = 0 lies within cells, not between two.
NdtMap ndt_map(const FramedCloud& cloud, const NdtCellConfig& config);

}  // namespace weft::agents
