#include "clients/evaluate/topometric/obstacles_trial.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/topometric/clearance.hpp"
#include "clients/evaluate/topometric/deliveries_trial.hpp"
#include "clients/evaluate/topometric/map_trial.hpp"
#include "clients/evaluate/topometric/odometry_errors.hpp"
#include "clients/evaluate/topometric/shown_lines.hpp"
#include "core/random.hpp"

namespace weft::evaluate::topometric {
namespace {

using namespace agents;

constexpr std::uint64_t kDayOfObstacles = 1;
constexpr std::uint64_t kObstaclesOfSeed = 73;
constexpr double kComesWithinM = 1.5;
constexpr double kKnowsWithinS = 40.0;

/// Puts crates on the line, each a little to one side of it, and lets persons walk across and along it.
sim::Site with_obstacles(sim::Site site, const std::vector<SitePoint>& line, const InTheWay& what,
                         std::uint64_t seed) {
  constexpr std::array heights_m = {0.6, 0.15, 0.4};
  Random random = Random(seed).fork(kObstaclesOfSeed);
  const double length_m = floor::length_of(line);
  const auto on_line = [&](double along_m, double aside_m) {
    return beginning_of(floor::stretch(line, along_m, along_m + 0.1)) * Pose2{0.0, aside_m, 0.0};
  };
  for (std::size_t i = 0; i < what.crates; ++i) {
    sim::Obstacle crate;
    crate.name = "crate " + std::to_string(i + 1);
    const double share = (static_cast<double>(i) + 1.0) / (static_cast<double>(what.crates) + 1.0);
    const double aside_m = (random.chance(0.5) ? 1.0 : -1.0) * random.uniform(0.05, 0.3);
    crate.site_from_obstacle = on_line(share * length_m + random.uniform(-0.3, 0.3), aside_m);
    crate.length_m = 0.6;
    crate.width_m = 0.5;
    crate.height_m = heights_m[i % heights_m.size()];
    crate.from_day = kDayOfObstacles;
    site.obstacles.push_back(crate);
  }
  for (std::size_t i = 0; i < what.walkers; ++i) {
    const double at_m = length_m * (i % 2 == 0 ? 0.38 : 0.62);
    const Pose2 here = on_line(at_m, 0.0);
    sim::Mover person;
    person.name = "person " + std::to_string(i + 1);
    const auto at = [&](double ahead_m, double left_m) {
      const Eigen::Vector2d point = here * Eigen::Vector2d(ahead_m, left_m);
      return SitePoint{point.x(), point.y()};
    };
    // The first walks across the way, the second along it.
    person.way = i % 2 == 0 ? std::vector<SitePoint>{at(0.0, -1.2), at(0.0, 2.0)}
                            : std::vector<SitePoint>{at(-2.5, 1.1), at(1.5, 1.1)};
    person.speed_m_s = random.uniform(0.5, 0.9);
    person.begins_m = random.uniform(0.0, 3.0);
    site.movers.push_back(std::move(person));
  }
  return site;
}

/// Closes the southern corridor of level11 from wall to wall.
sim::Site with_closed_corridor(sim::Site site) {
  sim::Obstacle pile;
  pile.name = "pile";
  pile.site_from_obstacle = {8.7, 0.9, 0.0};
  pile.length_m = 0.4;
  pile.width_m = 1.8;
  pile.height_m = 1.2;
  pile.from_day = kDayOfObstacles;
  site.obstacles.push_back(pile);
  return site;
}

/// Holds a drive to one goal, with its truth.
struct OneDrive {
  Delivery delivery;
  Moments moments;
};

Result<std::optional<OneDrive>> drive_once(const sim::Site& site, const Driven& driven, const Taught& taught,
                                           const PlaceId& goal, const DeliveryLimits& limits) {
  const PlaceId first = taught.runs.front().places.front();
  const Rider rider =
      rider_of(with_start(site, "r1", taught.site_from_place.at(first)), "r1", driven, kDayOfObstacles);
  const auto ride = Ride::make(rider);
  if (!ride) return fail(ride.error());
  const auto found = find_itself(**ride, rider, taught, first, kKnowsWithinS);
  if (!found) return fail(found.error());
  if (!*found) return std::optional<OneDrive>();
  auto delivery = deliver(**ride, rider, taught, goal, limits);
  if (!delivery) return fail(delivery.error());
  if (!*delivery) return std::optional<OneDrive>();
  auto moments = (*ride)->finish();
  if (!moments) return fail(moments.error());
  return std::optional(OneDrive{std::move(**delivery), std::move(*moments)});
}

void add_nearness(const sim::Site& site, const Moments& moments, Score& score) {
  const std::vector<double> clearances = clearances_m(site, kDayOfObstacles, moments);
  score.values["contacts"] = contacts(moments);
  score.values["clearance_m"] = *std::min_element(clearances.begin(), clearances.end());
}

/// Returns the seconds from when it came near what closes its way until it was said to be blocked. Not a number: it
/// never was.
double told_after_s(const sim::Site& site, const OneDrive& drive) {
  if (!drive.delivery.blocked_sample) return Score::kNothing;
  const sim::Obstacle& pile = site.obstacles.back();
  const auto came = std::find_if(drive.moments.begin(), drive.moments.end(), [&](const Moment& moment) {
    return to_rim_m(pile.site_from_obstacle, pile.length_m, pile.width_m, moment.site_from_robot.translation()) <
           kComesWithinM + site.base.radius_m;
  });
  const double told_s = drive.moments[*drive.delivery.blocked_sample].sensor_s;
  return came == drive.moments.end() ? 0.0 : std::max(0.0, told_s - came->sensor_s);
}

}  // namespace

Result<std::optional<Measured>> measure_obstacles(const Scenes& scenes, const Driven& driven, const InTheWay& what) {
  const std::vector<SitePoint> line = floor::stretch(scenes.hall.line, 0.0, what.metres);
  const auto taught = teach_line(scenes.hall.site, line, driven);
  if (!taught) return fail(taught.error());
  if (!*taught) return std::optional<Measured>();
  const sim::Site site = with_obstacles(scenes.hall.site, line, what, driven.seed);
  const auto drive = drive_once(site, driven, **taught, (*taught)->runs.front().places.back(), {});
  if (!drive) return fail(drive.error());
  if (!*drive) return std::optional<Measured>();
  Measured measured;
  add_nearness(site, (*drive)->moments, measured.score);
  add_deliveries({(*drive)->delivery}, (*drive)->moments, **taught, measured.score);
  if (!(*drive)->delivery.has_arrived) measured.said.push_back((*drive)->delivery.ended);
  measured.shown["truth"] = path_of((*drive)->moments);
  measured.shown["taught"] = path_of((*taught)->runs.front().moments);
  measured.shown["walls"] = outlines_of(TrueHall(site, kDayOfObstacles));
  return std::optional(std::move(measured));
}

Result<std::optional<Measured>> measure_blocked(const sim::Site& site, const Driven& driven, const Taught& taught) {
  constexpr double beyond_m = 13.0;  // along the corridor, past the pile
  const sim::Site closed = with_closed_corridor(site);
  const Pose2 first = taught.site_from_place.at(taught.runs.front().places.front());
  const PlaceId goal = taught.nearest((first * Pose2{beyond_m, 0.0, 0.0}).translation());
  DeliveryLimits limits;
  limits.most_m_after_blocked = 10.0;  // it is enough to see where it goes
  const auto drive = drive_once(closed, driven, taught, goal, limits);
  if (!drive) return fail(drive.error());
  if (!*drive) return std::optional<Measured>();
  const Delivery& delivery = (*drive)->delivery;
  const bool went_round = delivery.blocked_sample && (delivery.has_arrived || delivery.ended == "driven far enough");
  Measured measured;
  measured.score.values = {{"told", delivery.blocked_sample ? 1.0 : 0.0},
                           {"told_s", told_after_s(closed, **drive)},
                           {"went_round", went_round ? 1.0 : 0.0}};
  add_nearness(closed, (*drive)->moments, measured.score);
  if (!delivery.ended.empty()) measured.said.push_back(delivery.ended);
  measured.shown["truth"] = path_of((*drive)->moments);
  return std::optional(std::move(measured));
}

}  // namespace weft::evaluate::topometric
