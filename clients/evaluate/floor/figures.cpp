#include "clients/evaluate/floor/figures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

#include "clients/chart/chart.hpp"
#include "clients/evaluate/floor/measures.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::floor {
namespace {

using namespace charts;
using Look = Curve::Look;
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr std::array kPalette = {kBlue, kVermilion, kGreen, kOrange, kPurple, kSky, kInk, kQuiet};

const Colour& colour_of(std::size_t i) {
  return kPalette.at(i % kPalette.size());
}

/// None of a run that never began.
std::vector<Dot> true_path(const Trace& trace) {
  std::vector<Dot> dots;
  if (trace.moments.size() < 2) return dots;
  for (const Moment& moment : trace.moments) dots.push_back({moment.site_from_robot.x, moment.site_from_robot.y});
  return dots;
}

/// Odometry, laid on the truth at its start.
std::vector<Dot> inferred_path(const Trace& trace) {
  const Moment& first = trace.moments.front();
  const Pose2 site_from_start = first.site_from_robot * first.start_from_robot.inverse();
  std::vector<Dot> dots;
  for (const Moment& moment : trace.moments) {
    const Pose2 pose = site_from_start * moment.start_from_robot;
    dots.push_back({pose.x, pose.y});
  }
  return dots;
}

/// Where the fixes of a repeat say that it was, by the true poses of the places.
std::vector<Dot> fixed_path(const Trace& trace, const PlaceSet& places) {
  std::vector<Dot> dots;
  for (const Moment& moment : trace.moments) {
    if (!moment.fix) continue;
    const Pose2 pose = places.site_from_place.at(moment.fix->place) * moment.fix->measured;
    dots.push_back({pose.x, pose.y});
  }
  return dots;
}

/// What the panel of a floor is called; one on which nothing could be measured says why.
std::string title(const Shown& shown, const std::string& more = {}) {
  if (fixes(shown.repeated) == 0) return shown.kind + ": the robot did not find itself, and stood";
  return shown.kind + (more.empty() ? "" : ": " + more);
}

Chart scale_chart(const Shown& shown, double camera_height_m) {
  Chart chart{shown.kind, "time while teaching, s", "height of the camera, m", {}, false, {}, false};
  Curve inferred{"inferred: true / measured way x given height", {}, kBlue, Look::line, 1.2};
  for (const SpeedWindow& window : speed_windows(shown.taught)) {
    inferred.dots.push_back({window.true_s, camera_height_m * window.v_true_m_s / window.v_m_s});
  }
  const double end_s = shown.taught.moments.back().true_s;
  chart.curves = {inferred, {"given", {{0.0, camera_height_m}, {end_s, camera_height_m}}, kInk, Look::dashed, 1.4}};
  chart.y_range = Dot{0.9 * camera_height_m, 1.1 * camera_height_m};
  return chart;
}

Chart speed_chart(const Shown& shown) {
  Chart chart{shown.kind + ": " + cell(speed_error(shown.taught).percent, 2) + " % off",
              "time while teaching, s",
              "speed over 5 frames, m/s",
              {},
              false,
              {},
              true};
  Curve truth{"true", {}, kInk, Look::line, 2.4};
  Curve inferred{"inferred", {}, kVermilion, Look::line, 1.1};
  for (const SpeedWindow& window : speed_windows(shown.taught)) {
    truth.dots.push_back({window.true_s, window.v_true_m_s});
    inferred.dots.push_back({window.true_s, window.v_m_s});
  }
  chart.curves = {truth, inferred};
  return chart;
}

Chart path_chart(const Shown& shown) {
  return {shown.kind,
          "x, m",
          "y, m",
          {{"true", true_path(shown.taught), kInk, Look::line, 2.4},
           {"odometry", inferred_path(shown.taught), kVermilion, Look::line, 1.3}},
          true,
          {},
          false};
}

/// Means over whole seconds, views without a motion counted as 0.
std::vector<Dot> matches_of(const Trace& trace) {
  std::map<int, std::pair<double, double>> by_second;  // sum and count
  for (const Moment& moment : trace.moments) {
    auto& [sum, count] = by_second[static_cast<int>(moment.true_s)];
    sum += static_cast<double>(moment.matches);
    count += 1.0;
  }
  std::vector<Dot> dots;
  for (const auto& [second, of] : by_second) dots.push_back({second + 0.5, of.first / of.second});
  return dots;
}

std::array<Chart, 3> rate_charts(const Shown& shown) {
  Chart matches{shown.kind + ": matches", "time, s", "matches a view, mean of 1 s", {}, false, {}, true};
  Chart speed{shown.kind + ": speed", "time, s", "inferred speed, m/s", {}, false, {}, true};
  Chart path{shown.kind + ": path", "x, m", "y, m", {}, true, {}, false};
  std::size_t i = 0;
  for (auto at = shown.at_rates.rbegin(); at != shown.at_rates.rend(); ++at, ++i) {
    const std::string name = cell(at->first, at->first < 10.0 ? 1 : 0) + " fps";
    Curve inferred{name, {}, colour_of(i), Look::line, 1.1};
    for (const SpeedWindow& window : speed_windows(at->second))
      inferred.dots.push_back({window.true_s, window.v_m_s});
    matches.curves.push_back({name, matches_of(at->second), colour_of(i), Look::line, 1.4});
    speed.curves.push_back(std::move(inferred));
    path.curves.push_back({name, inferred_path(at->second), colour_of(i), Look::line, 1.3});
  }
  if (!shown.at_rates.empty()) {
    path.curves.insert(path.curves.begin(),
                       {"true", true_path(shown.at_rates.rbegin()->second), kInk, Look::dashed, 1.6});
  }
  return {matches, speed, path};
}

Chart localisation_chart(const Shown& shown) {
  const PlaceSet places = places_of(shown.taught);
  return {title(shown, cell(fixes(shown.repeated), 0) + " fixes"),
          "x, m",
          "y, m",
          {{"where its fixes say it was", fixed_path(shown.repeated, places), kOrange, Look::dots, 3.0},
           {"map (true)", true_path(shown.taught), kVermilion, Look::line, 2.6},
           {"query (true)", true_path(shown.repeated), kBlue, Look::line, 1.2}},
          true,
          {},
          false};
}

Chart consistency_chart(const Shown& shown) {
  const auto stretches = fixed_stretches(shown.repeated, places_of(shown.taught).start_from_place);
  Chart chart{title(shown, cell(consistency_percent(stretches), 2) + " % apart"),
              "time while repeating, s",
              "speed between fixes, m/s",
              {},
              false,
              {},
              true};
  Curve odometry{"odometry", {}, kInk, Look::line, 2.4};
  Curve fixed{"localisation", {}, kOrange, Look::line, 1.2};
  for (const FixedStretch& stretch : stretches) {
    odometry.dots.push_back({stretch.true_s, stretch.v_odometry_m_s});
    fixed.dots.push_back({stretch.true_s, stretch.v_fixes_m_s});
  }
  chart.curves = {odometry, fixed};
  return chart;
}

/// Share of the blind stretches that are at least so long, as steps.
Curve at_least(const std::string& name, std::vector<double> distances, const Colour& ink) {
  Curve curve{name, {}, ink, Look::steps, 1.8};
  std::sort(distances.begin(), distances.end());
  const auto count = static_cast<double>(distances.size());
  curve.dots.push_back({0.0, 1.0});
  for (std::size_t i = 0; i < distances.size(); ++i) {
    curve.dots.push_back({distances[i], (count - static_cast<double>(i)) / count});
  }
  if (!distances.empty()) curve.dots.push_back({distances.back() + 1e-6, 0.0});
  return curve;
}

/// A chart a light, a curve a floor, over all seeds.
std::vector<Chart> blind_charts(const Rows& rows, Seeds seeds) {
  std::map<std::string, std::map<std::string, std::vector<double>>> by_light;
  for (const auto& [key, score] : rows) {
    if (key.part == kMapping || key.seed < seeds.first || key.seed > seeds.last) continue;
    auto& all = by_light[key.part][key.kind];
    all.insert(all.end(), score.blind_distances_m.begin(), score.blind_distances_m.end());
  }
  std::vector<Chart> charts;
  for (const auto& [light, by_kind] : by_light) {
    Chart chart{"repeated under: " + light,
                "x: true distance without a right fix, m",
                "P(X >= x)",
                {},
                false,
                Dot{0.0, 1.02},
                false};
    std::size_t i = 0;
    for (const auto& [kind, distances] : by_kind) chart.curves.push_back(at_least(kind, distances, colour_of(i++)));
    charts.push_back(std::move(chart));
  }
  return charts;
}

std::array<Chart, 2> repeat_charts(const Shown& shown) {
  Chart off{title(shown, "beside the path"), "driven, m", "to the left, mm", {}, false, {}, false};
  Curve curve{"true pose against the taught path", {}, kBlue, Look::line, 1.3};
  for (const OffPath& now : off_path(shown.repeated, TaughtPath(shown.taught))) {
    curve.dots.push_back({now.driven_m, 1e3 * now.lateral_m});
  }
  off.curves = {curve};
  if (!curve.dots.empty()) {
    const double end_m = curve.dots.back().x;
    off.curves.push_back({"30 mm", {{0.0, 30.0}, {end_m, 30.0}}, kQuiet, Look::dashed, 1.2});
    off.curves.push_back({"", {{0.0, -30.0}, {end_m, -30.0}}, kQuiet, Look::dashed, 1.2});
  }
  return {Chart{shown.kind,
                "x, m",
                "y, m",
                {{"taught (true)", true_path(shown.taught), kVermilion, Look::line, 3.0},
                 {"repeated (true)", true_path(shown.repeated), kBlue, Look::line, 1.3}},
                true,
                {},
                false},
          off};
}

Chart heading_chart(const Shown& shown) {
  Chart chart{title(shown), "time while repeating, s", "heading error, degrees", {}, false, {}, false};
  Curve curve{"true heading against the taught one", {}, kBlue, Look::line, 1.3};
  for (const OffPath& now : off_path(shown.repeated, TaughtPath(shown.taught))) {
    curve.dots.push_back({now.true_s, kDegrees * now.heading_rad});
  }
  chart.curves = {curve};
  return chart;
}

Chart two_chart(const Shown& shown) {
  return {title(shown),
          "x, m",
          "y, m",
          {{"first experience", true_path(shown.two_taught.at(0)), kVermilion, Look::line, 4.0},
           {"second, another robot", true_path(shown.two_taught.at(1)), kGreen, Look::line, 3.0},
           {"repeated as one", true_path(shown.two_repeated), kInk, Look::line, 1.3}},
          true,
          {},
          false};
}

}  // namespace

Result<std::vector<std::string>> draw_figures(const Pictured& pictured, const Rows& rows, Seeds seeds,
                                              const std::filesystem::path& folder) {
  const auto of_each = [&](const auto& chart_of) {
    std::vector<Chart> charts;
    for (const Shown& shown : pictured.kinds) charts.push_back(chart_of(shown));
    return charts;
  };
  std::vector<Chart> rates;
  std::vector<Chart> repeats;
  for (const Shown& shown : pictured.kinds) {
    for (Chart& chart : rate_charts(shown)) rates.push_back(std::move(chart));
    for (Chart& chart : repeat_charts(shown)) repeats.push_back(std::move(chart));
  }
  struct Figure {
    const char* file;
    const char* title;
    std::vector<Chart> charts;
    std::size_t columns;
    bool is_of_all = false;  ///< lights and seeds
  };
  const std::vector<Figure> figures = {
      {"6a-scale.png", "Scale over time",
       of_each([&](const Shown& shown) { return scale_chart(shown, pictured.camera_height_m); }), 2},
      {"6b-speed.png", "Inferred and true speed while mapping", of_each(speed_chart), 2},
      {"6c-paths.png", "Ground-plane trajectories while mapping", of_each(path_chart), 2},
      {"7-frame-rates.png", "Fewer images a second", rates, 3},
      {"8a-localisation.png", "Localisation of another robot on another day", of_each(localisation_chart), 2},
      {"8b-consistency.png", "Odometry and localisation say how fast it drove", of_each(consistency_chart), 2},
      {"9-blind.png", "Driven without a right fix", blind_charts(rows, seeds), 2, true},
      {"10a-repeat.png", "Repeated against taught", repeats, 2},
      {"10b-heading.png", "Heading error over the repeat", of_each(heading_chart), 2},
      {"10c-two-experiences.png", "Two experiences repeated as one", of_each(two_chart), 2},
  };
  const std::string of_all = "seeds " + std::to_string(seeds.first) + " to " + std::to_string(seeds.last);
  std::vector<std::string> names;
  for (const Figure& figure : figures) {
    const std::string name = std::string("floor-") + figure.file;
    const std::string about = pictured.about + ", " + (figure.is_of_all ? of_all : pictured.of_first);
    if (auto drawn = draw_charts(figure.title, about, figure.charts, figure.columns, folder / name); !drawn)
      return fail(drawn.error());
    names.push_back(name);
  }
  return names;
}

}  // namespace weft::evaluate::floor
