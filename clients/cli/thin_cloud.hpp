#pragma once
#include "core/result.hpp"
#include "storage/formats/cloud.hpp"

namespace weft::cli {

/// Describes what is taken from a cloud of others before it is written again.
struct Thinning {
  double alone_m = 0.0;  ///< points with fewer than `neighbours` others this near are left out; 0: none is
  int neighbours = 3;
  double voxel_m = 0.0;  ///< one point, the mean, is left of each cube; 0: all are

  bool is_any() const { return alone_m > 0.0 || voxel_m > 0.0; }
};

/// Returns the cloud without order and without rays that met nothing, thinned. Means of voxels have coordinates
/// alone: colours, intensities and normals are gone then. invalid: the voxels are too small to be numbered.
Result<formats::Cloud> thinned(const formats::Cloud& cloud, const Thinning& thinning);

}  // namespace weft::cli
