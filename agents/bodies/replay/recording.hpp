#pragma once
#include <optional>
#include <string>
#include <vector>

#include "agents/perception/motion.hpp"
#include "core/result.hpp"
#include "core/time.hpp"

namespace weft::agents::replay {

/// Holds one row of data.csv.
struct RecordedImage {
  SensorTime time{};
  std::string file;  ///< as the row names it
};

/// Parses rows "nanoseconds,file" under a # header; times must increase. invalid: file, line and what is wrong.
Result<std::vector<RecordedImage>> parse_image_list(const std::string& text, const std::string& file_name);

/// Holds the distance and angle that the wheels had rolled and turned the base by a time, since any beginning.
struct RecordedWheels {
  SensorTime time{};
  double distance_m = 0.0;
  double heading_rad = 0.0;  ///< not wrapped
};

/// Parses rows "nanoseconds,metres,radians" under a # header; times must increase. invalid: file, line, what is
/// wrong.
Result<std::vector<RecordedWheels>> parse_wheels(const std::string& text, const std::string& file_name);

/// Returns the wheels' motion, read between the rows around each of the two times; none outside of them.
std::optional<WheelStep> wheels_between(const std::vector<RecordedWheels>& rows, SensorTime from, SensorTime to);

}  // namespace weft::agents::replay
