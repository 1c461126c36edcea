#pragma once
#include <string>

#include "storage/clouds/cloud.hpp"

namespace weft::clouds {

/// Declares codecs of other libraries, with the same error bound: `quantum_m` / 2 on each axis. An empty result, or
/// one of no points, is a failure.

/// Encodes with PCL's octree coder: points relative to their voxel's corner, cut off at `quantum_m` / 2, which is
/// their error. `voxel_steps`: size of a voxel in those steps, at most 127, what its byte holds.
std::string pcl_compressed(const Cloud& cloud, double quantum_m, int voxel_steps);
std::size_t pcl_point_count(const std::string& compressed);

/// Encodes with Draco's kd-tree coder, rounding to `quantum_m`. `speed`: 0 smallest to 10 fastest.
std::string draco_compressed(const Cloud& cloud, double quantum_m, int speed);
std::size_t draco_point_count(const std::string& compressed);

}  // namespace weft::clouds
