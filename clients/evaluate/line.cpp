#include "clients/evaluate/line.hpp"

#include <cmath>
#include <sstream>

namespace weft::evaluate {

using agents::SitePoint;

Result<std::vector<SitePoint>> parse_line(std::string_view text, const std::string& file) {
  std::vector<SitePoint> points;
  std::istringstream rows{std::string(text)};
  std::size_t number = 0;
  for (std::string row; std::getline(rows, row);) {
    ++number;
    std::istringstream fields(row.substr(0, row.find('#')));
    if ((fields >> std::ws).eof()) continue;
    SitePoint point;
    std::string rest;
    if (!(fields >> point.x >> point.y) || (fields >> rest) || !std::isfinite(point.x) || !std::isfinite(point.y)) {
      return fail(ErrorCode::invalid,
                  file + ":" + std::to_string(number) + ": '" + row + "' is no point; write 'x y' in metres");
    }
    points.push_back(point);
  }
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
