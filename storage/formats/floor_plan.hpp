#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "storage/formats/grey_image.hpp"
#include "storage/formats/not_understood.hpp"

namespace weft::formats {

/// Describes a building from above: cells row by row, the bottom row first, as nav_msgs/OccupancyGrid has them.
struct FloorPlan {
  static constexpr std::int8_t kUnknown = -1;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  double cell_m = 0.0;
  Pose2 plan_from_grid;            ///< the grid's frame: the lower left corner of its first cell, x along the rows
  std::vector<std::int8_t> cells;  ///< occupied in percent, 0 to 100, or kUnknown
};

/// Holds what the YAML file of ROS's map_server says.
struct MapServerFile {
  enum class Mode : std::uint8_t { trinary, scale, raw };
  std::string image;  ///< beside the YAML file, unless absolute
  double resolution_m = 0.0;
  Pose2 origin;  ///< of the lower left pixel
  bool negate = false;
  double occupied_thresh = 0.0;
  double free_thresh = 0.0;
  Mode mode = Mode::trinary;  ///< as map_server has it when the file names none
};

/// Reads a map_server file. Lists keys that map_server does not have. invalid, with file and line: no YAML, a missing
/// key, a value out of bounds (resolution (0, 100] m, thresholds in [0, 1] with free below occupied).
Result<Read<MapServerFile>> read_map_server(std::string_view text, std::string_view file);

/// Gives each pixel its meaning, by the rules of the mode: with p = 1 - value / white (negate: value / white),
/// trinary takes p > occupied_thresh for occupied, p < free_thresh for free, all else is unknown; scale spreads what
/// lies between over 0 to 100; raw takes the value itself, of 255, and what is above 100 for unknown. Of an image
/// with opacities trinary takes the mean of red, green, blue and opacity for the value, and scale what is not opaque
/// for unknown.
FloorPlan floor_plan_from(const MapServerFile& file, const GreyImage& image);

}  // namespace weft::formats
