#pragma once
#include <string>
#include <vector>

#include "core/result.hpp"
#include "core/time.hpp"

namespace weft::agents::replay {

/// One row of data.csv.
struct RecordedImage {
  SensorTime time{};
  std::string file;  ///< as the row names it
};

/// Rows "nanoseconds,file" under a # header; times must increase. invalid: file, line and what is wrong.
Result<std::vector<RecordedImage>> parse_image_list(const std::string& text, const std::string& file_name);

}  // namespace weft::agents::replay
