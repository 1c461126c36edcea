#include "clients/evaluate/line.hpp"

#include <cmath>

#include "core/polyline.hpp"

namespace weft::evaluate {

using agents::SitePoint;

Result<std::vector<SitePoint>> parse_line(std::string_view text, const std::string& file) {
  const Result<std::vector<PolylinePoint>> read = parse_polyline_points(text, file);
  if (!read) return fail(read.error());
  std::vector<SitePoint> points;
  for (const auto& [x, y] : *read) points.push_back({x, y});
  return points;
}

Result<std::vector<SitePoint>> first_metres(const std::vector<SitePoint>& line, double metres,
                                            const std::string& file) {
  std::vector<SitePoint> part;
  double along = 0.0;
  for (const SitePoint& p : line) {
    if (!part.empty()) {
      const SitePoint& last = part.back();
      const double step = std::hypot(p.x - last.x, p.y - last.y);
      if (along + step >= metres) {
        const double share = (metres - along) / step;
        part.push_back({last.x + share * (p.x - last.x), last.y + share * (p.y - last.y)});
        return part;
      }
      along += step;
    }
    part.push_back(p);
  }
  return fail(ErrorCode::invalid, file + ": is " + std::to_string(along) + " m long, " + std::to_string(metres) +
                                      " m are wanted; give another with --along, or fewer --metres");
}

}  // namespace weft::evaluate
