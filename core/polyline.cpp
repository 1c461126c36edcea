#include "core/polyline.hpp"

#include <cmath>
#include <sstream>
#include <string>

#include "core/text.hpp"

namespace weft {
namespace {

constexpr double kFarthestPoint = 1e5;

/// Reads the point of a row. invalid: what is wrong with the row.
Result<PolylinePoint> parse_point(const std::string& row) {
  std::istringstream fields(row);
  PolylinePoint point;
  std::string rest;
  if (!(fields >> point.x >> point.y) || (fields >> rest) || !std::isfinite(point.x) || !std::isfinite(point.y)) {
    return fail(ErrorCode::invalid, "'" + row + "' is no point; write 'x y' in metres");
  }
  if (std::abs(point.x) > kFarthestPoint || std::abs(point.y) > kFarthestPoint) {
    return fail(ErrorCode::invalid, "'" + row + "' lies beyond +-100000 m; write 'x y' in metres");
  }
  return point;
}

}  // namespace

Result<std::vector<PolylinePoint>> parse_polyline_points(std::string_view text, std::string_view file) {
  std::vector<PolylinePoint> points;
  std::istringstream rows{std::string(without_byte_order_mark(text))};
  std::size_t number = 0;
  for (std::string row; std::getline(rows, row);) {
    ++number;
    row.erase(std::min(row.find('#'), row.size()));
    for (char& c : row) c = c == ',' || c == '\r' ? ' ' : c;
    if (row.find_first_not_of(" \t") == std::string::npos) continue;
    const Result<PolylinePoint> point = parse_point(row);
    if (!point) {
      return fail(ErrorCode::invalid,
                  std::string(file) + ":" + std::to_string(number) + ": " + point.error().message);
    }
    points.push_back(*point);
  }
  return points;
}

}  // namespace weft
