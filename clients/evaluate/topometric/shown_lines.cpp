#include "clients/evaluate/topometric/shown_lines.hpp"

#include <cmath>
#include <limits>

namespace weft::evaluate::topometric {
namespace {

constexpr double kApartM = 0.05;
constexpr double kApartS = 1.0;

std::array<double, 2> point_at(const Eigen::Vector2d& at) {
  return {at.x(), at.y()};
}

void add_apart(const Eigen::Vector2d& at, Points& points) {
  const bool is_near = !points.empty() && std::hypot(at.x() - points.back()[0], at.y() - points.back()[1]) < kApartM;
  if (!is_near) points.push_back(point_at(at));
}

}  // namespace

Points path_of(const Moments& moments) {
  Points points;
  for (const Moment& moment : moments) add_apart(moment.site_from_robot.translation(), points);
  return points;
}

Points path_of(const Moments& moments, Pose2 Moment::*chain) {
  Points points;
  if (moments.empty()) return points;
  const Pose2 site_from_start = moments.front().site_from_robot * (moments.front().*chain).inverse();
  for (const Moment& moment : moments) add_apart((site_from_start * (moment.*chain)).translation(), points);
  return points;
}

Points believed_path_of(const Moments& moments, const TruePlaces& places) {
  Points points;
  for (const Moment& moment : moments) {
    if (!moment.believed || moment.lost) continue;
    const auto place = places.find(moment.believed->place);
    if (place != places.end()) add_apart((place->second * moment.believed->place_from_robot).translation(), points);
  }
  return points;
}

Points outlines_of(const TrueHall& hall) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  Points points;
  for (const TrueSolid& solid : hall.solids()) {
    const double ahead = solid.length_m / 2;
    const double left = solid.width_m / 2;
    for (const auto& [x, y] : {std::pair(ahead, left), std::pair(-ahead, left), std::pair(-ahead, -left),
                               std::pair(ahead, -left), std::pair(ahead, left)})
      points.push_back(point_at(solid.site_from_solid * Eigen::Vector2d(x, y)));
    points.push_back({none, none});
  }
  return points;
}

Points occupied_of(const agents::OccupancyGrid& grid, const Pose2& site_from_grid) {
  Points points;
  for (int row = 0; row < grid.raster.rows; ++row)
    for (int column = 0; column < grid.raster.columns; ++column)
      if (grid.at(agents::Cell{column, row}) == agents::CellState::occupied)
        points.push_back(point_at(site_from_grid * grid.raster.centre({column, row})));
  return points;
}

Points over_time(const Moments& moments, const std::vector<double>& values) {
  Points points;
  for (std::size_t i = 0; i < moments.size() && i < values.size(); ++i)
    if (points.empty() || moments[i].sensor_s - points.back()[0] >= kApartS)
      points.push_back({moments[i].sensor_s, values[i]});
  return points;
}

}  // namespace weft::evaluate::topometric
