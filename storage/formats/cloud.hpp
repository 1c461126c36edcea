#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/bytes.hpp"
#include "core/geometry/pose3.hpp"
#include "storage/formats/not_understood.hpp"

namespace weft::formats {

/// Holds a point cloud as files do. Metres in the sensor's frame; a point whose coordinates are NaN is a ray of an
/// organised cloud that met nothing. What a cloud does not have is empty, otherwise there is one a point.
struct Cloud {
  std::vector<Eigen::Vector3f> points;
  std::vector<float> intensities;
  std::vector<std::array<std::uint8_t, 3>> colours;  ///< red, green, blue
  std::vector<Eigen::Vector3f> normals;
  std::uint64_t width = 0;  ///< width * height == points.size(); height is 1 for a cloud without order
  std::uint64_t height = 1;
  Pose3 world_from_sensor;  ///< PCD's VIEWPOINT; PLY has none
};

enum class CloudCoding : std::uint8_t { text, binary };

/// Reads PCD 0.5 to 0.7: ascii, binary and binary_compressed. Fields x y z, intensity, rgb or rgba, normal_x normal_y
/// normal_z; others, second ones and what follows the last point are listed. Before 0.7 fields may be called COLUMNS,
/// are floats of four bytes when SIZE and TYPE are missing, and WIDTH may be missing beside POINTS.
/// invalid or corrupt, with file and line, in binary data with the point: what the header does not say or
/// contradicts, fields that are not numbers, infinite coordinates, data that is short.
Result<Read<Cloud>> read_pcd(ByteView bytes, std::string_view file);
Bytes pcd_bytes(const Cloud& cloud, CloudCoding coding);

/// Reads PLY 1.0: ascii, binary_little_endian and binary_big_endian. Of the element vertex x y z, intensity (also
/// CloudCompare's scalar_intensity), red green blue as uchar or ushort, which is scaled, nx ny nz; other properties,
/// elements after it, and what follows the last row are listed. Errors as for PCD; a vertex with a list, and elements
/// before vertex, are refused.
Result<Read<Cloud>> read_ply(ByteView bytes, std::string_view file);
/// Writes PLY. An organised cloud loses its order: PLY has none.
Bytes ply_bytes(const Cloud& cloud, CloudCoding coding);

}  // namespace weft::formats
