#include "clients/evaluate/topometric/true_hall.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace weft::evaluate::topometric {
namespace {

using agents::sim::Box;
using agents::sim::Obstacle;
using agents::sim::Site;

constexpr double kPlainContrast = 0.05;  // walls below it show nothing
constexpr double kInsideM = 1e-3;
constexpr double kNeverMet = std::numeric_limits<double>::infinity();

/// Narrows the stretch of a ray to what lies between two planes across an axis. False: nothing is left.
bool clip(double from, double way, double low, double high, double& enters, double& leaves) {
  if (std::abs(way) < 1e-12) return from >= low && from <= high;
  const double to_low = (low - from) / way;
  const double to_high = (high - from) / way;
  enters = std::max(enters, std::min(to_low, to_high));
  leaves = std::min(leaves, std::max(to_low, to_high));
  return enters <= leaves;
}

double meets_solid_after(const TrueSolid& solid, const Eigen::Vector3d& from, const Eigen::Vector3d& way) {
  const Pose2 solid_from_site = solid.site_from_solid.inverse();
  const Eigen::Vector2d begins = solid_from_site * from.head<2>().eval();
  const Eigen::Vector2d goes = solid_from_site * (from.head<2>() + way.head<2>()).eval() - begins;
  double enters = 0.0;
  double leaves = kNeverMet;
  const bool meets = clip(begins.x(), goes.x(), -solid.length_m / 2, solid.length_m / 2, enters, leaves) &&
                     clip(begins.y(), goes.y(), -solid.width_m / 2, solid.width_m / 2, enters, leaves) &&
                     clip(from.z(), way.z(), 0.0, solid.height_m, enters, leaves);
  return meets ? enters : kNeverMet;
}

double meets_level_after(double height_m, const Eigen::Vector3d& from, const Eigen::Vector3d& way) {
  if (std::abs(way.z()) < 1e-12) return kNeverMet;
  const double after = (height_m - from.z()) / way.z();
  return after > 0.0 ? after : kNeverMet;
}

/// Adds points along one side of a solid, which lies so far ahead of its middle once that is turned by quarters.
void add_side(const TrueSolid& solid, int quarters, double apart_m, std::vector<OutlinePoint>& points) {
  constexpr double quarter_rad = 1.5707963267948966;
  const Pose2 site_from_side = solid.site_from_solid * Pose2{0.0, 0.0, quarters * quarter_rad};
  const bool is_end = quarters % 2 == 0;
  const double ahead_m = (is_end ? solid.length_m : solid.width_m) / 2;
  const double long_m = is_end ? solid.width_m : solid.length_m;
  const int count = std::max(1, static_cast<int>(long_m / apart_m));
  const Eigen::Vector2d outwards(std::cos(site_from_side.heading), std::sin(site_from_side.heading));
  for (int i = 0; i < count; ++i) {
    const double aside_m = long_m * ((i + 0.5) / count - 0.5);
    points.push_back({site_from_side * Eigen::Vector2d(ahead_m, aside_m), outwards, solid.is_plain});
  }
}

}  // namespace

double to_rim_m(const Pose2& site_from_middle, double length_m, double width_m, const Eigen::Vector2d& in_site) {
  const Eigen::Vector2d at = site_from_middle.inverse() * in_site;
  const double beyond_x = std::abs(at.x()) - length_m / 2;
  const double beyond_y = std::abs(at.y()) - width_m / 2;
  if (beyond_x <= 0.0 && beyond_y <= 0.0) return std::max(beyond_x, beyond_y);
  return std::hypot(std::max(0.0, beyond_x), std::max(0.0, beyond_y));
}

TrueHall::TrueHall(const Site& site, std::uint64_t day) : ceiling_m_(site.hall.ceiling_m) {
  for (const Box& box : site.boxes)
    solids_.push_back({box.name, box.site_from_box, box.length_m, box.width_m, box.height_m,
                       box.kind == Box::Kind::wall && box.contrast < kPlainContrast});
  for (const Obstacle& obstacle : site.obstacles)
    if (obstacle.from_day <= day)
      solids_.push_back({obstacle.name, obstacle.site_from_obstacle, obstacle.length_m, obstacle.width_m,
                         obstacle.height_m, false});
}

double TrueHall::meets_after(const Eigen::Vector3d& from, const Eigen::Vector3d& way) const {
  double after = std::min(meets_level_after(0.0, from, way), meets_level_after(ceiling_m_, from, way));
  for (const TrueSolid& solid : solids_) after = std::min(after, meets_solid_after(solid, from, way));
  return after;
}

double TrueHall::to_rim_m(const Eigen::Vector2d& in_site) const {
  double nearest_m = kNeverMet;
  for (const TrueSolid& solid : solids_)
    nearest_m =
        std::min(nearest_m, topometric::to_rim_m(solid.site_from_solid, solid.length_m, solid.width_m, in_site));
  return nearest_m;
}

std::vector<OutlinePoint> TrueHall::outline(double apart_m) const {
  std::vector<OutlinePoint> points;
  for (const TrueSolid& solid : solids_)
    for (int quarters = 0; quarters < 4; ++quarters) add_side(solid, quarters, apart_m, points);
  // A side that touches another solid is no rim: just outside of it there is something.
  std::erase_if(points, [this](const OutlinePoint& point) {
    return to_rim_m(point.in_site + 2.0 * kInsideM * point.outwards) < kInsideM;
  });
  return points;
}

}  // namespace weft::evaluate::topometric
