#include "tests/simulation/site.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/simulation/aisles_course.hpp"
#include "tests/simulation/grid_course.hpp"
#include "tests/simulation/ring_course.hpp"

namespace weft::simulation {
namespace {

constexpr double kSidingHalf = 4.0;  // a siding leaves the course this far before its station
constexpr double kSidingRamp = 2.5;  // and takes this long to be beside it

}  // namespace

double Site::right_m(double along_m, const std::vector<std::size_t>& through) const {
  double right = 0.0;
  for (const std::size_t k : through) {
    const Station& station = course_->stations()[k];
    const double away = std::abs(std::remainder(along_m - station.at_m, length_m()));
    if (away >= kSidingHalf) continue;
    const double share = std::min(1.0, (kSidingHalf - away) / kSidingRamp);
    const double here = station.right_m * 0.5 * (1.0 - std::cos(std::numbers::pi * share));
    if (std::abs(here) > std::abs(right)) right = here;
  }
  return right;
}

Pose2 Site::pose(double along_m, const std::vector<std::size_t>& through) const {
  const auto point = [&](double at_m) { return course_->at(at_m) * Eigen::Vector2d(0.0, -right_m(at_m, through)); };
  const Eigen::Vector2d here = point(along_m);
  const Eigen::Vector2d ahead = point(along_m + 0.01) - point(along_m - 0.01);
  return {here.x(), here.y(), std::atan2(ahead.y(), ahead.x())};
}

std::vector<agents::SitePoint> Site::line(double from_m, double to_m, const std::vector<std::size_t>& through) const {
  std::vector<agents::SitePoint> points;
  const auto count = static_cast<std::size_t>(std::ceil((to_m - from_m) / 0.25));
  for (std::size_t i = 0; i <= count; ++i) {
    const Pose2 at = pose(from_m + (to_m - from_m) * static_cast<double>(i) / static_cast<double>(count), through);
    points.push_back({at.x, at.y});
  }
  return points;
}

Site::Spot Site::nearest(const Pose2& site_from_robot) const {
  constexpr double step_m = 0.1;
  Spot nearest;
  double least_m = 1e9;
  const auto look = [&](double at_m, const std::vector<std::size_t>& through) {
    const Pose2 there = pose(at_m, through);
    const double away_m = (there.translation() - site_from_robot.translation()).norm();
    const bool leads_on = std::abs(wrap_angle(there.heading - site_from_robot.heading)) < std::numbers::pi / 2.0;
    if (away_m >= least_m || !leads_on) return;
    least_m = away_m;
    nearest = {at_m, through};
  };
  for (double at_m = 0.0; at_m < length_m(); at_m += step_m) {
    for (std::size_t k = 0; k < stations(); ++k) {
      const Station& station = course_->stations()[k];
      if (station.right_m == 0.0) continue;
      if (std::abs(std::remainder(at_m - station.at_m, length_m())) < kSidingHalf) look(at_m, {k});
    }
    look(at_m, {});
  }
  return nearest;
}

agents::Marks read_marks(const Site& site, const Pose2& site_from_robot, Random& random) {
  agents::Marks marks{site.seen_from(site_from_robot)};
  for (auto& sighting : marks.sightings) {
    sighting.robot_from_mark.x += random.normal(0.0, 0.004);
    sighting.robot_from_mark.y += random.normal(0.0, 0.004);
    sighting.robot_from_mark.heading = wrap_angle(sighting.robot_from_mark.heading + random.normal(0.0, 0.008));
  }
  return marks;
}

const std::vector<std::string>& site_names() {
  static const std::vector<std::string> names = {"ring", "aisles"};
  return names;
}

/// Makes the site. Its marks reach some metres beyond the course.
Site make_site(std::string_view name, Random random) {
  if (name == "ring") return {std::make_unique<RingCourse>(), MarkedFloor(-6.0, -6.0, 46, 28, random)};
  if (name == "aisles") return {std::make_unique<AislesCourse>(), MarkedFloor(-10.0, -14.0, 38, 28, random)};
  throw std::invalid_argument("there is no site " + std::string(name));
}

Site make_large_site(std::size_t robots, Random random) {
  constexpr double margin_m = 14.0;
  auto course = std::make_unique<GridCourse>(robots);
  const auto columns = static_cast<int>(course->east_m() + 2.0 * margin_m);
  const auto rows = static_cast<int>(course->north_m() + 2.0 * margin_m);
  return {std::move(course), MarkedFloor(-margin_m, -margin_m, columns, rows, random)};
}

}  // namespace weft::simulation
