#include "clients/cli/polygon.hpp"

#include <cmath>
#include <string>

#include "storage/formats/lines.hpp"

namespace weft::cli {
namespace {

constexpr double kLeastArea_m2 = 1e-4;

/// Returns twice the area, positive or negative by the order of the corners (the shoelace formula).
double twice_area(const Polygon& polygon) {
  double sum = 0.0;
  for (std::size_t at = 0; at < polygon.size(); ++at) {
    const Eigen::Vector2d& here = polygon[at];
    const Eigen::Vector2d& next = polygon[(at + 1) % polygon.size()];
    sum += here.x() * next.y() - next.x() * here.y();
  }
  return sum;
}

}  // namespace

Result<Polygon> parse_polygon(std::string_view text) {
  Polygon polygon;
  const auto wrong = [&](const std::string& why) {
    return fail(ErrorCode::invalid, "'" + std::string(text) + "' " + why + "; write X,Y;X,Y;X,Y, 3 to " +
                                        std::to_string(kMostCorners) +
                                        " corners in metres of the registered plan's frame");
  };
  for (const std::string_view corner : formats::cells_of(text, ';')) {
    const std::vector<std::string_view> numbers = formats::cells_of(corner, ',');
    const auto x = numbers.size() == 2 ? formats::parse_finite(numbers[0]) : std::nullopt;
    const auto y = numbers.size() == 2 ? formats::parse_finite(numbers[1]) : std::nullopt;
    if (!x || !y) return wrong("has the corner '" + std::string(corner) + "', which is no X,Y");
    polygon.emplace_back(*x, *y);
  }
  if (polygon.size() < 3 || polygon.size() > kMostCorners)
    return wrong("has " + std::to_string(polygon.size()) + " corners");
  if (!(std::abs(twice_area(polygon)) >= 2.0 * kLeastArea_m2)) return wrong("encloses nothing");
  return polygon;
}

bool contains(const Polygon& polygon, const Eigen::Vector2d& point) {
  bool is_inside = false;
  for (std::size_t at = 0; at < polygon.size(); ++at) {
    const Eigen::Vector2d& a = polygon[at];
    const Eigen::Vector2d& b = polygon[(at + 1) % polygon.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double crossing = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    if (point.x() < crossing) is_inside = !is_inside;
  }
  return is_inside;
}

Result<std::vector<Span>> spans_within(const Layout& layout, const Polygon& polygon) {
  std::vector<Span> spans;
  for (const auto& [place, pose] : layout.drawing_from_place) {
    if (!contains(polygon, pose.translation())) continue;
    const bool goes_on =
        !spans.empty() && spans.back().to.experience == place.experience && spans.back().to.index + 1 == place.index;
    if (goes_on) {
      spans.back().to = place;
    } else {
      spans.push_back({place, place});
    }
  }
  if (spans.empty()) {
    return fail(ErrorCode::not_found,
                "--polygon: no place of the map lies within it; weft map draw --floor-plan shows where they lie");
  }
  if (spans.size() > kRuleSpans) {
    return fail(ErrorCode::invalid, "--polygon: " + std::to_string(spans.size()) +
                                        " stretches of runs lie within it, and a rule names at most " +
                                        std::to_string(kRuleSpans) + "; lay down several rules for smaller pieces");
  }
  return spans;
}

}  // namespace weft::cli
