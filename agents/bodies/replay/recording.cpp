#include "agents/bodies/replay/recording.hpp"

#include <charconv>
#include <sstream>

namespace weft::agents::replay {
namespace {

tl::unexpected<Error> at_line(const std::string& file, int line, const std::string& what) {
  return fail(ErrorCode::invalid, file + ":" + std::to_string(line) + ": " + what);
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  const auto last = text.find_last_not_of(" \t\r");
  return first == std::string::npos ? std::string() : text.substr(first, last - first + 1);
}

}  // namespace

Result<std::vector<RecordedImage>> parse_image_list(const std::string& text, const std::string& file_name) {
  std::vector<RecordedImage> images;
  std::istringstream rows(text);
  int line = 0;
  for (std::string row; std::getline(rows, row);) {
    ++line;
    row = trimmed(row);
    if (row.empty() || row.front() == '#') {
      continue;
    }
    const auto comma = row.find(',');
    std::int64_t nanoseconds = 0;
    const char* end = row.data() + std::min(comma, row.size());
    const auto [stop, error] = std::from_chars(row.data(), end, nanoseconds);
    if (comma == std::string::npos || error != std::errc() || stop != end || nanoseconds < 0) {
      return at_line(file_name, line, "expected \"nanoseconds,file\", found \"" + row.substr(0, 80) + "\"");
    }
    const std::string file = trimmed(row.substr(comma + 1));
    if (file.empty() || file.find('/') != std::string::npos) {
      return at_line(file_name, line, "the file's name must be that of a file in data/");
    }
    const SensorTime time{Duration(nanoseconds)};
    if (!images.empty() && time <= images.back().time) {
      return at_line(file_name, line, "time does not increase");
    }
    images.push_back({time, file});
  }
  if (images.empty()) {
    return fail(ErrorCode::invalid, file_name + ": lists no image");
  }
  return images;
}

}  // namespace weft::agents::replay
