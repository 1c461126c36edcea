#include "clients/evaluate/topometric/deliveries_trial.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "clients/evaluate/topometric/belief_errors.hpp"
#include "clients/evaluate/topometric/clearance.hpp"
#include "clients/evaluate/topometric/map_trial.hpp"
#include "clients/evaluate/topometric/odometry_errors.hpp"
#include "clients/evaluate/topometric/shown_lines.hpp"
#include "clients/evaluate/topometric/spread.hpp"

namespace weft::evaluate::topometric {
namespace {

using namespace agents;

constexpr double kDegreesOf = 180.0 / std::numbers::pi;
constexpr double kFindsItselfS = 40.0;
constexpr std::uint64_t kDayAfter = 1;

/// Returns how far a heading is off another, either of them or turned round: who drives both ways may stand so.
double axis_off_rad(double radians) {
  const double off = std::abs(wrap_angle(radians));
  return std::min(off, std::numbers::pi - off);
}

std::vector<PlaceId> goals_of(const sim::Site& site, const Taught& taught) {
  std::vector<PlaceId> goals;
  for (const sim::Station& station : site.stations)
    goals.push_back(taught.nearest(station.site_from_station.translation()));
  return goals;
}

/// Drives to one goal after the other. False: stopped.
Result<bool> deliver_in_turn(Ride& ride, const Rider& rider, const Taught& taught, const DeliveryPlan& plan,
                             const std::vector<PlaceId>& goals, std::vector<Delivery>& deliveries) {
  double driven_m = 0.0;
  for (std::size_t i = 0; driven_m < plan.most_m && ride.now_s() < plan.most_s; ++i) {
    Result<std::optional<Delivery>> delivery = deliver(ride, rider, taught, goals[i % goals.size()], {});
    if (!delivery) return fail(delivery.error());
    if (!*delivery) return false;
    driven_m += (*delivery)->route_m;
    deliveries.push_back(std::move(**delivery));
    if (!deliveries.back().has_arrived) return true;  // nobody helps it
  }
  return true;
}

Measured judge_deliveries(const sim::Site& site, const Taught& taught, const std::vector<Delivery>& deliveries,
                          const Moments& moments) {
  Measured measured;
  Score& score = measured.score;
  add_odometry(moments, score);
  add_located(moments, taught.site_from_place, score);
  add_processor(moments, score);
  add_deliveries(deliveries, moments, taught, score);
  score.values["fixes_hidden"] = fixes_while_hidden(site, moments);
  score.values["contacts"] = contacts(moments);
  score.values["minutes"] = moments.back().sensor_s / 60.0;
  measured.shown["truth"] = path_of(moments);
  measured.shown["open"] = path_of(moments, &Moment::start_from_robot);
  measured.shown["raw"] = path_of(moments, &Moment::raw_start_from_robot);
  measured.shown["located"] = believed_path_of(moments, taught.site_from_place);
  measured.shown["open_error"] = over_time(moments, chain_errors_m(moments, &Moment::start_from_robot));
  measured.shown["raw_error"] = over_time(moments, chain_errors_m(moments, &Moment::raw_start_from_robot));
  std::vector<double> blind;
  for (const Moment& moment : moments) blind.push_back(moment.seen ? 0.0 : 1.0);
  measured.shown["blind"] = over_time(moments, blind);
  for (const Moment& moment : moments)
    if (moment.has_switched)
      measured.shown["switches"].push_back({moment.site_from_robot.x, moment.site_from_robot.y});
  for (const Delivery& delivery : deliveries) {
    const Pose2& goal = taught.site_from_place.at(delivery.goal);
    measured.shown["goals"].push_back({goal.x, goal.y});
  }
  return measured;
}

}  // namespace

void add_located(const Moments& moments, const TruePlaces& places, Score& score) {
  const BeliefErrors located = belief_errors(moments, places);
  score.values["located_mean_m"] = mean_of(located.metres);
  score.values["located_p95_m"] = quantile(located.metres, 0.95);
  score.values["located_p95_deg"] = kDegreesOf * quantile(located.radians, 0.95);
  const SwitchErrors switches = switch_errors(moments);
  score.values["switches"] = static_cast<double>(switches.jumps_m.size());
  score.values["jump_median_m"] = quantile(switches.jumps_m, 0.5);
  score.values["jump_largest_m"] = largest_of(switches.jumps_m);
  score.values["switch_stands_s"] = quantile(switches.stands_s, 0.5);
  score.values["switch_stands_largest_s"] = largest_of(switches.stands_s);
  const FixErrors fixes = fix_errors(moments, places);
  score.values["held_fixes_percent"] = fixes.held_percent;
  score.values["fix_nees"] = fixes.mean_nees;
  score.values["fixes"] = static_cast<double>(
      std::count_if(moments.begin(), moments.end(), [](const Moment& moment) { return moment.fix.has_value(); }));
  score.values["lost_samples"] = static_cast<double>(
      std::count_if(moments.begin(), moments.end(), [](const Moment& moment) { return moment.lost; }));
}

void add_processor(const Moments& moments, Score& score) {
  std::vector<double> each_ms;
  for (const Moment& moment : moments)
    if (moment.has_view) each_ms.push_back(moment.processor_ms);
  score.values["median_ms"] = quantile(each_ms, 0.5);
  score.values["p99_ms"] = quantile(each_ms, 0.99);
}

void add_deliveries(const std::vector<Delivery>& deliveries, const Moments& moments, const Taught& taught,
                    Score& score) {
  double reached = 0.0;
  double metres = 0.0;
  double took_s = 0.0;
  double turned = 0.0;
  double blocked = 0.0;
  std::vector<double> off_m;
  std::vector<double> off_deg;
  const std::vector<double> driven = metres_driven(moments);
  for (const Delivery& delivery : deliveries) {
    metres += driven[delivery.to_sample] - driven[delivery.from_sample];
    took_s += moments[delivery.to_sample].sensor_s - moments[delivery.from_sample].sensor_s;
    blocked += static_cast<double>(delivery.blocked);
    if (!delivery.has_arrived) continue;
    reached += 1.0;
    const Pose2 goal_from_robot =
        taught.site_from_place.at(delivery.goal).inverse() * moments[delivery.to_sample].site_from_robot;
    off_m.push_back(goal_from_robot.translation().norm());
    off_deg.push_back(kDegreesOf * axis_off_rad(goal_from_robot.heading));
    turned += std::abs(goal_from_robot.heading) > std::numbers::pi / 2 ? 1.0 : 0.0;
  }
  score.values["goals"] = static_cast<double>(deliveries.size());
  score.values["reached_percent"] = percent_of(reached, static_cast<double>(deliveries.size()));
  score.values["goals_turned_round"] = turned;
  score.values["mean_speed_m_s"] = took_s > 0.0 ? metres / took_s : Score::kNothing;
  score.values["delivered_m"] = metres;
  score.values["blocked"] = blocked;
  score.values["goal_median_m"] = quantile(off_m, 0.5);
  score.values["goal_largest_m"] = largest_of(off_m);
  score.values["goal_median_deg"] = quantile(off_deg, 0.5);
  score.values["goal_largest_deg"] = largest_of(off_deg);
}

Result<std::optional<Measured>> measure_deliveries(const sim::Site& site, const Driven& driven, const Taught& taught,
                                                   const DeliveryPlan& plan) {
  constexpr double blackouts_from_s = 10.0;
  sim::Site now = site;
  now.blackouts = blackouts(plan.blackouts, blackouts_from_s, plan.blackouts_to_s, driven.seed);
  const PlaceId first = taught.runs.front().places.front();
  const Rider rider = rider_of(with_start(now, "r1", taught.site_from_place.at(first)), "r1", driven, kDayAfter);
  const auto ride = Ride::make(rider);
  if (!ride) return fail(ride.error());
  const auto found = find_itself(**ride, rider, taught, first, kFindsItselfS);
  if (!found) return fail(found.error());
  if (!*found) return std::optional<Measured>();
  const std::vector<PlaceId> goals = plan.goals.empty() ? goals_of(site, taught) : plan.goals;
  std::vector<Delivery> deliveries;
  const Result<bool> driven_all = deliver_in_turn(**ride, rider, taught, plan, goals, deliveries);
  if (!driven_all) return fail(driven_all.error());
  if (!*driven_all) return std::optional<Measured>();
  const Result<Moments> moments = (*ride)->finish();
  if (!moments) return fail(moments.error());
  Measured measured = judge_deliveries(now, taught, deliveries, *moments);
  for (const Delivery& delivery : deliveries)
    if (!delivery.has_arrived) measured.said.push_back(delivery.ended);
  return std::optional(std::move(measured));
}

}  // namespace weft::evaluate::topometric
