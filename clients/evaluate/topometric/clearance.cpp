#include "clients/evaluate/topometric/clearance.hpp"

#include <algorithm>

#include "agents/bodies/sim/hall/movers.hpp"
#include "agents/bodies/sim/solids.hpp"
#include "clients/evaluate/topometric/true_hall.hpp"

namespace weft::evaluate::topometric {
namespace {

using agents::sim::Mover;
using agents::sim::Obstacle;
using agents::sim::Site;

// Are the sizes of what moves, seen from above: a person with arms, and a forklift with its forks about their middle.
constexpr double kPersonLongM = 0.4, kPersonWideM = 0.64;
constexpr double kForkliftLongM = 2.75, kForkliftWideM = 1.1, kForkliftMiddleM = 0.275;

double to_mover_m(const Mover& mover, double at_s, const Eigen::Vector2d& in_site) {
  const Pose2 stands = agents::sim::pose_of(mover, at_s);
  if (mover.kind == Mover::Kind::person) return to_rim_m(stands, kPersonLongM, kPersonWideM, in_site);
  return to_rim_m(stands * Pose2{kForkliftMiddleM, 0.0, 0.0}, kForkliftLongM, kForkliftWideM, in_site);
}

Site without_obstacles(Site site) {
  site.obstacles.clear();
  return site;
}

}  // namespace

std::vector<double> clearances_m(const Site& site, std::uint64_t day, const Moments& moments) {
  const TrueHall walls(without_obstacles(site), day);
  agents::sim::Solids solids(site);  // says how long movers have waited for the robot
  std::vector<double> clearances;
  double before_s = 0.0;
  for (const Moment& moment : moments) {
    solids.advance(moment.site_from_robot, moment.true_s - before_s);
    before_s = moment.true_s;
    const Eigen::Vector2d at = moment.site_from_robot.translation();
    double nearest_m = walls.to_rim_m(at);
    for (const Obstacle& obstacle : site.obstacles)
      if (obstacle.from_day <= day && obstacle.stands_at(moment.true_s))
        nearest_m =
            std::min(nearest_m, to_rim_m(obstacle.site_from_obstacle, obstacle.length_m, obstacle.width_m, at));
    for (std::size_t i = 0; i < site.movers.size(); ++i)
      nearest_m = std::min(nearest_m, to_mover_m(site.movers[i], moment.true_s - solids.waited_s()[i], at));
    clearances.push_back(nearest_m - site.base.radius_m);
  }
  return clearances;
}

double contacts(const Moments& moments) {
  double count = 0.0;
  for (std::size_t i = 0; i < moments.size(); ++i)
    if (moments[i].touch && (i == 0 || !moments[i - 1].touch)) count += 1.0;
  return count;
}

}  // namespace weft::evaluate::topometric
