#include "clients/evaluate/topometric/one_way_trial.hpp"

#include <utility>

#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/topometric/deliveries_trial.hpp"
#include "clients/evaluate/topometric/map_trial.hpp"
#include "clients/evaluate/topometric/odometry_errors.hpp"
#include "clients/evaluate/topometric/shown_lines.hpp"

namespace weft::evaluate::topometric {
namespace {

using namespace agents;

constexpr double kOneWayM = 26.0;
constexpr double kStandsWithinS = 40.0;
constexpr std::uint64_t kNextDay = 1;

/// Holds a drive to one goal after the other, with its truth.
struct Drive {
  std::vector<Delivery> deliveries;
  Moments moments;
};

/// Switches a robot on at the first place and sends it to these goals. None: stopped.
Result<std::optional<Drive>> drive_to(const sim::Site& site, const std::string& robot, const Driven& driven,
                                      const Taught& taught, const std::vector<PlaceId>& goals) {
  const PlaceId first = taught.runs.front().places.front();
  const Rider rider = rider_of(with_start(site, robot, taught.site_from_place.at(first)), robot, driven, kNextDay);
  const auto ride = Ride::make(rider);
  if (!ride) return fail(ride.error());
  const auto found = find_itself(**ride, rider, taught, first, kStandsWithinS);
  if (!found) return fail(found.error());
  if (!*found) return std::optional<Drive>();
  Drive drive;
  for (const PlaceId& goal : goals) {
    auto delivery = deliver(**ride, rider, taught, goal, {});
    if (!delivery) return fail(delivery.error());
    if (!*delivery) return std::optional<Drive>();
    drive.deliveries.push_back(std::move(**delivery));
    if (!drive.deliveries.back().has_arrived) break;
  }
  auto moments = (*ride)->finish();
  if (!moments) return fail(moments.error());
  drive.moments = std::move(*moments);
  return std::optional(std::move(drive));
}

Moments part_of(const Moments& moments, const Delivery& delivery) {
  return {moments.begin() + static_cast<std::ptrdiff_t>(delivery.from_sample),
          moments.begin() + static_cast<std::ptrdiff_t>(delivery.to_sample + 1)};
}

void say_why(const std::vector<Delivery>& deliveries, Measured& measured) {
  for (const Delivery& delivery : deliveries)
    if (!delivery.has_arrived) measured.said.push_back(delivery.ended);
}

}  // namespace

Result<std::optional<Measured>> measure_one_way(const Scenes& scenes, const Driven& driven) {
  const auto taught = teach_line(scenes.level11.site, floor::stretch(scenes.level11.line, 0.0, kOneWayM), driven);
  if (!taught) return fail(taught.error());
  if (!*taught) return std::optional<Measured>();
  const std::vector<PlaceId>& places = (*taught)->runs.front().places;
  const auto drive = drive_to(scenes.level11.site, "r1", driven, **taught, {places.back(), places.front()});
  if (!drive) return fail(drive.error());
  if (!*drive) return std::optional<Measured>();
  Measured measured;
  const std::vector<Delivery>& deliveries = (*drive)->deliveries;
  add_located(part_of((*drive)->moments, deliveries.front()), (*taught)->site_from_place, measured.score);
  add_deliveries(deliveries, (*drive)->moments, **taught, measured.score);
  const bool went_back = deliveries.size() == 2;
  measured.score.values["back_reached"] = went_back && deliveries.back().has_arrived ? 100.0 : 0.0;
  if (went_back) {
    Score back;
    add_located(part_of((*drive)->moments, deliveries.back()), (*taught)->site_from_place, back);
    for (const auto& [name, value] : back.values) measured.score.values["back_" + name] = value;
  }
  say_why(deliveries, measured);
  measured.shown["truth"] = path_of((*drive)->moments);
  measured.shown["taught"] = path_of((*taught)->runs.front().moments);
  return std::optional(std::move(measured));
}

Result<std::optional<Measured>> measure_other_robot(const Scenes& scenes, const Driven& driven) {
  const auto taught = teach_line(scenes.level11.site, floor::stretch(scenes.level11.line, 0.0, kOneWayM), driven);
  if (!taught) return fail(taught.error());
  if (!*taught) return std::optional<Measured>();
  const auto drive = drive_to(scenes.level11.site, "r2", driven, **taught, {(*taught)->runs.front().places.back()});
  if (!drive) return fail(drive.error());
  if (!*drive) return std::optional<Measured>();
  Measured measured;
  add_located((*drive)->moments, (*taught)->site_from_place, measured.score);
  add_deliveries((*drive)->deliveries, (*drive)->moments, **taught, measured.score);
  say_why((*drive)->deliveries, measured);
  measured.shown["truth"] = path_of((*drive)->moments);
  measured.shown["taught"] = path_of((*taught)->runs.front().moments);
  return std::optional(std::move(measured));
}

Result<std::optional<Measured>> measure_shortcut(const Scenes& scenes, const Driven& driven, double from_m,
                                                 double to_m) {
  const auto taught = teach_line(scenes.hall.site, floor::stretch(scenes.hall.line, from_m, to_m), driven);
  if (!taught) return fail(taught.error());
  if (!*taught) return std::optional<Measured>();
  const Run& run = (*taught)->runs.front();
  const auto drive = drive_to(scenes.hall.site, "r1", driven, **taught, {run.places.back()});
  if (!drive) return fail(drive.error());
  if (!*drive) return std::optional<Measured>();
  Measured measured;
  Score& score = measured.score;
  const double driven_m = metres_in((*drive)->moments);
  const double taught_m = metres_in(run.moments);
  const bool has_arrived = (*drive)->deliveries.front().has_arrived;
  score.values["arrived"] = has_arrived ? 1.0 : 0.0;
  score.values["taught_m"] = taught_m;
  score.values["driven_m"] = driven_m;
  score.values["driven_share"] = has_arrived ? driven_m / taught_m : Score::kNothing;
  score.values["route_m"] = (*drive)->deliveries.front().route_m;
  say_why((*drive)->deliveries, measured);
  measured.shown["truth"] = path_of((*drive)->moments);
  measured.shown["taught"] = path_of(run.moments);
  measured.shown["walls"] = outlines_of(TrueHall(scenes.hall.site, 0));
  return std::optional(std::move(measured));
}

}  // namespace weft::evaluate::topometric
