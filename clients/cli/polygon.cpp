#include "clients/cli/polygon.hpp"

#include <optional>
#include <string>
#include <utility>

#include "storage/formats/lines.hpp"

namespace weft::cli {
namespace {

/// Returns a positive number for a point on the left of the line from `a` to `b`, a negative one on the right.
double side_of(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& point) {
  const Eigen::Vector2d along = b - a;
  const Eigen::Vector2d to = point - a;
  return along.x() * to.y() - along.y() * to.x();
}

/// Returns whether the straight line from `a` to `b` leads over an edge of the polygon.
bool crosses(const Polygon& polygon, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  for (std::size_t at = 0; at < polygon.size(); ++at) {
    const Eigen::Vector2d& c = polygon[at];
    const Eigen::Vector2d& d = polygon[(at + 1) % polygon.size()];
    const bool is_between = (side_of(a, b, c) > 0.0) != (side_of(a, b, d) > 0.0);
    if (is_between && (side_of(c, d, a) > 0.0) != (side_of(c, d, b) > 0.0)) return true;
  }
  return false;
}

}  // namespace

Result<Polygon> parse_polygon(std::string_view text) {
  Polygon polygon;
  const auto wrong = [&](const std::string& why) {
    return fail(ErrorCode::invalid, "'" + std::string(text) + "' " + why + "; write X,Y;X,Y;X,Y, " +
                                        std::to_string(kLeastCorners) + " to " + std::to_string(kMostCorners) +
                                        " corners in metres of the registered plan's frame");
  };
  for (const std::string_view corner : formats::cells_of(text, ';')) {
    const std::vector<std::string_view> numbers = formats::cells_of(corner, ',');
    const auto x = numbers.size() == 2 ? formats::parse_finite(numbers[0]) : std::nullopt;
    const auto y = numbers.size() == 2 ? formats::parse_finite(numbers[1]) : std::nullopt;
    if (!x || !y) return wrong("has the corner '" + std::string(corner) + "', which is no X,Y");
    polygon.emplace_back(*x, *y);
  }
  const std::string problem = problem_of(polygon);
  if (!problem.empty()) return wrong(problem);
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

std::set<PlaceId> places_within(const Layout& layout, const Polygon& polygon) {
  std::set<PlaceId> within;
  const std::pair<const PlaceId, Pose2>* before = nullptr;
  for (const auto& entry : layout.drawing_from_place) {
    const auto& [place, pose] = entry;
    const bool is_next =
        before != nullptr && before->first.experience == place.experience && before->first.index + 1 == place.index;
    if (contains(polygon, pose.translation())) {
      within.insert(place);
    } else if (is_next && !contains(polygon, before->second.translation()) &&
               crosses(polygon, before->second.translation(), pose.translation())) {
      within.insert({before->first, place});
    }
    before = &entry;
  }
  return within;
}

Result<std::vector<Span>> spans_within(const Layout& layout, const Polygon& polygon) {
  const std::set<PlaceId> within = places_within(layout, polygon);
  std::vector<Span> spans;
  std::optional<PlaceId> before;  // what has left the map between two places of a run breaks no stretch
  for (const auto& [place, pose] : layout.drawing_from_place) {
    if (within.contains(place)) {
      const bool goes_on = !spans.empty() && before == spans.back().to && before->experience == place.experience;
      if (goes_on) {
        spans.back().to = place;
      } else {
        spans.push_back({place, place});
      }
    }
    before = place;
  }
  if (spans.empty()) {
    return fail(ErrorCode::not_found,
                "the polygon: no place of the map lies within it, and no run leads through it; weft map draw "
                "--floor-plan shows where they lie");
  }
  if (spans.size() > kRuleSpans) {
    return fail(ErrorCode::invalid, "the polygon: " + std::to_string(spans.size()) +
                                        " stretches of runs lie within it, and a rule names at most " +
                                        std::to_string(kRuleSpans) + "; lay down several rules for smaller pieces");
  }
  return spans;
}

}  // namespace weft::cli
