#pragma once
#include <filesystem>

#include "core/result.hpp"
#include "storage/clouds/cloud.hpp"

namespace weft::clouds {

/// Returns the points of a recorded cloud, in metres, without those that are not finite (rays that met nothing).
/// Reads what the recordings need: VTK as text, PLY of four little-endian floats a vertex, PCD with x y z
/// binary_compressed. not_found, invalid: no such file; another kind.
Result<Cloud> read_cloud(const std::filesystem::path& file);

}  // namespace weft::clouds
