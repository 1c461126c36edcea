#include "agents/bodies/replay/recording.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

#include "core/text.hpp"

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
  std::istringstream rows{std::string(without_byte_order_mark(text))};
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

Result<std::vector<RecordedWheels>> parse_wheels(const std::string& text, const std::string& file_name) {
  std::vector<RecordedWheels> rows;
  std::istringstream lines{std::string(without_byte_order_mark(text))};
  int line = 0;
  for (std::string row; std::getline(lines, row);) {
    ++line;
    row = trimmed(row);
    if (row.empty() || row.front() == '#') continue;
    std::istringstream cells(row);
    std::int64_t nanoseconds = 0;
    RecordedWheels wheels;
    char first = 0;
    char second = 0;
    std::string rest;
    if (!(cells >> nanoseconds >> first >> wheels.distance_m >> second >> wheels.heading_rad) || first != ',' ||
        second != ',' || (cells >> rest) || nanoseconds < 0 || !std::isfinite(wheels.distance_m) ||
        !std::isfinite(wheels.heading_rad)) {
      return at_line(file_name, line, "expected \"nanoseconds,metres,radians\", found \"" + row.substr(0, 80) + "\"");
    }
    wheels.time = SensorTime{Duration(nanoseconds)};
    if (!rows.empty() && wheels.time <= rows.back().time) return at_line(file_name, line, "time does not increase");
    rows.push_back(wheels);
  }
  return rows;
}

namespace {

std::optional<WheelStep> rolled_by(const std::vector<RecordedWheels>& rows, SensorTime time) {
  const auto after = std::ranges::lower_bound(rows, time, {}, &RecordedWheels::time);
  if (after == rows.end()) return std::nullopt;
  if (after->time == time) return WheelStep{after->distance_m, after->heading_rad};
  if (after == rows.begin()) return std::nullopt;
  const RecordedWheels& before = *(after - 1);
  const double part = seconds(time - before.time) / seconds(after->time - before.time);
  return WheelStep{before.distance_m + part * (after->distance_m - before.distance_m),
                   before.heading_rad + part * (after->heading_rad - before.heading_rad)};
}

}  // namespace

std::optional<WheelStep> wheels_between(const std::vector<RecordedWheels>& rows, SensorTime from, SensorTime to) {
  const std::optional<WheelStep> a = rolled_by(rows, from);
  const std::optional<WheelStep> b = rolled_by(rows, to);
  if (!a.has_value() || !b.has_value()) return std::nullopt;
  return WheelStep{b->distance_m - a->distance_m, b->heading_rad - a->heading_rad};
}

}  // namespace weft::agents::replay
