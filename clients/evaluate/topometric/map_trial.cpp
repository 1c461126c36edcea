#include "clients/evaluate/topometric/map_trial.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/topometric/charted_places.hpp"
#include "clients/evaluate/topometric/edge_errors.hpp"
#include "clients/evaluate/topometric/odometry_errors.hpp"
#include "clients/evaluate/topometric/shown_lines.hpp"
#include "clients/evaluate/topometric/spread.hpp"

namespace weft::evaluate::topometric {
namespace {

using namespace agents;

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr std::size_t kChartEvery = 8;  // places
constexpr double kSecondRunM = 14.0;    // of the line, with 5 m between plain walls
constexpr std::uint64_t kSecondDay = 1;

double rms_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return values.empty() ? Score::kNothing : std::sqrt(sum / static_cast<double>(values.size()));
}

void add_edges(const Taught& taught, Score& score) {
  const EdgeErrors edges = chain_errors(taught);
  score.values["registered_edges"] = edges.edges;
  score.values["across_mm"] = 1e3 * rms_of(edges.across_m);
  score.values["across_before_mm"] = 1e3 * rms_of(edges.across_before_m);
  score.values["along_mm"] = 1e3 * rms_of(edges.along_m);
  score.values["along_before_mm"] = 1e3 * rms_of(edges.along_before_m);
  score.values["across_ratio"] = rms_of(edges.across_m) / rms_of(edges.across_before_m);
  score.values["along_ratio"] = rms_of(edges.along_m) / rms_of(edges.along_before_m);
  score.values["grew_percent"] = percent_of(edges.grew, edges.edges);
  score.values["unmarked_blind"] = unmarked_blind_edges(taught);
}

void add_grid(const GridErrors& grid, Score& score) {
  score.values["grid_precision_percent"] = percent_of(grid.right_occupied, grid.occupied);
  score.values["grid_recall_percent"] = percent_of(grid.found, grid.known);
  score.values["free_inside_percent"] = percent_of(grid.free_inside, grid.free);
}

/// Has a second robot taught the beginning of the line. False: stopped.
Result<bool> add_second_run(const Scenes& scenes, const Driven& driven, Taught& both) {
  const std::vector<SitePoint> part = floor::stretch(scenes.level11.line, 0.0, kSecondRunM);
  const sim::Site site = on_beginning(scenes.level11.site, "r2", part);
  return teach(rider_of(site, "r2", driven, kSecondDay), part, both);
}

Result<void> add_walls(const Taught& both, const Topometric& method, const TrueHall& hall, Score& score) {
  const std::vector<PlaceId>& places = both.runs.back().places;
  const auto with = grid_errors_of(both.map, method, places, kChartEvery / 2, both.site_from_place, hall);
  if (!with) return fail(with.error());
  const auto without = grid_errors_of(both.unregistered, method, places, kChartEvery / 2, both.site_from_place, hall);
  if (!without) return fail(without.error());
  score.values["wall_mm"] = 1e3 * thickness_m(with->across_m);
  score.values["wall_unregistered_mm"] = 1e3 * thickness_m(without->across_m);
  score.values["wall_ratio"] = score.values["wall_mm"] / score.values["wall_unregistered_mm"];
  const StitchErrors stitches = stitch_errors(both);
  score.values["stitches"] = static_cast<double>(stitches.metres.size());
  score.values["stitch_m"] = quantile(stitches.metres, 0.5);
  score.values["stitch_deg"] = kDegrees * quantile(stitches.radians, 0.5);
  score.values["wrong_stitches"] = stitches.wrong;
  return {};
}

/// Shows the occupied cells of a chart of both runs, with and without what comparing contents has changed.
Result<void> show_overlay(const Taught& both, const Topometric& method, Shown& shown) {
  const std::vector<PlaceId>& places = both.runs.back().places;
  const PlaceId& centre = places[places.size() / 2];
  for (const auto& [name, map] :
       {std::pair("registered", &both.map), std::pair("unregistered", &both.unregistered)}) {
    const Result<Topometric::Chart> chart = chart_around(*map, method, centre);
    if (!chart) return fail(chart.error());
    shown[name] = occupied_of(chart->grid, both.site_from_place.at(centre));
  }
  return {};
}

}  // namespace

void add_odometry(const Moments& moments, Score& score) {
  const FollowedSteps followed = followed_steps(moments);
  const double open_m = mean_of(chain_errors_m(moments, &Moment::start_from_robot));
  const double raw_m = mean_of(chain_errors_m(moments, &Moment::raw_start_from_robot));
  score.values["driven_m"] = metres_in(moments);
  score.values["open_m"] = open_m;
  score.values["raw_m"] = raw_m;
  score.values["raw_times_open"] = raw_m / open_m;
  score.values["blind_percent"] = percent_of(followed.blind, followed.samples);
  score.values["wrong_seen_percent"] = percent_of(followed.wrong, followed.samples);
  score.values["largest_wrong_seen_m"] = followed.largest_wrong_m;
}

sim::Site level11_as_taught(const Scenes& scenes, const Driven& driven) {
  constexpr double from_s = 15.0;
  constexpr double to_s = 120.0;
  sim::Site site = on_beginning(scenes.level11.site, "r1", scenes.level11.line);
  site.blackouts = blackouts(2, from_s, to_s, driven.seed);
  sim::Mover person;
  person.name = "somebody in the lobby";
  person.way = {{10.6, 6.9}, {13.4, 6.9}};
  person.speed_m_s = 0.8;
  site.movers.push_back(std::move(person));
  return site;
}

Result<std::optional<Taught>> teach_line(const sim::Site& site, const std::vector<SitePoint>& line,
                                         const Driven& driven) {
  std::optional<Taught> taught(std::in_place);
  const Result<bool> led = teach(rider_of(on_beginning(site, "r1", line), "r1", driven, 0), line, *taught);
  if (!led) return fail(led.error());
  if (!*led) taught.reset();
  return taught;
}

Result<std::optional<Measured>> measure_map(const Scenes& scenes, const Driven& driven, const Taught& taught) {
  const sim::Site site = level11_as_taught(scenes, driven);
  const Run& run = taught.runs.front();
  Measured measured;
  Score& score = measured.score;
  score.values["places"] = static_cast<double>(run.places.size());
  add_odometry(run.moments, score);
  score.values["kept_hidden"] = kept_while_hidden(site, run.moments);
  add_edges(taught, score);
  const auto judge = Ride::make(rider_of(site, "r1", driven, 0));  // for its method alone
  if (!judge) return fail(judge.error());
  const Topometric& method = (*judge)->method();
  const TrueHall hall(site, 0);
  const auto grid = grid_errors_of(taught.map, method, run.places, kChartEvery, taught.site_from_place, hall);
  if (!grid) return fail(grid.error());
  add_grid(*grid, score);
  Taught both = taught;
  const Result<bool> second = add_second_run(scenes, driven, both);
  if (!second) return fail(second.error());
  if (!*second) return std::optional<Measured>();
  if (const Result<void> walls = add_walls(both, method, hall, score); !walls) return fail(walls.error());
  measured.shown["taught"] = path_of(run.moments);
  measured.shown["walls"] = outlines_of(hall);
  if (const Result<void> shown = show_overlay(both, method, measured.shown); !shown) return fail(shown.error());
  return std::optional(std::move(measured));
}

}  // namespace weft::evaluate::topometric
