#include <algorithm>
#include <cmath>
#include <fstream>

#include "tests/containers/light/robot.hpp"

namespace weft::light {
namespace {

constexpr std::size_t kTeachers = 2;  // each is led through every second station's siding

/// Returns how far along the way from its beginning a lesson comes by a station first.
double until(const simulation::Site& site, const simulation::Lesson& lesson, std::size_t station) {
  const double away = std::fmod(site.course().stations()[station].at_m - lesson.from_m, site.length_m());
  return lesson.from_m + (away < 0.0 ? away + site.length_m() : away);
}

std::string points(const simulation::Site& site, const simulation::Lesson& lesson, double from_m, double to_m) {
  std::string rows;
  for (const agents::SitePoint& point : site.line(from_m, to_m, lesson.through))
    rows += std::to_string(point.x) + " " + std::to_string(point.y) + "\n";
  return rows;
}

/// Returns where a robot stands at first, if its line begins elsewhere: in a siding.
std::string standing(const simulation::Site& site, const simulation::Lesson& lesson) {
  constexpr double kThere_m = 0.1;
  const Pose2 stands = site.pose(lesson.from_m, {});
  const agents::SitePoint first = site.line(lesson.from_m, lesson.to_m, lesson.through).front();
  if (std::hypot(first.x - stands.x, first.y - stands.y) < kThere_m) return {};
  return std::to_string(stands.x) + " " + std::to_string(stands.y) + "\n";
}

std::string line_of(const simulation::Site& site, std::size_t robot, std::size_t fleet) {
  const double from = site.course().start_m(robot, fleet);
  simulation::Lesson lesson = site.course().lesson(robot % kTeachers, kTeachers);
  lesson.to_m += from - lesson.from_m;
  lesson.from_m = from;
  std::vector<std::pair<double, std::size_t>> stops;
  for (const std::size_t station : lesson.through) stops.emplace_back(until(site, lesson, station), station);
  std::sort(stops.begin(), stops.end());
  std::string text = standing(site, lesson);
  for (const auto& [at, station] : stops) {
    text += points(site, lesson, lesson.from_m, at) + "# label station-" + std::to_string(station) + "\n";
    lesson.from_m = at;
  }
  return text + points(site, lesson, lesson.from_m, lesson.to_m);
}

}  // namespace

Result<void> write_lines(const Options& options) {
  const auto site = site_of(options);
  for (std::size_t number = options.first; number < options.first + options.robots; ++number) {
    const std::string file = options.lines + "/" + name_of(number) + ".line";
    std::ofstream out(file);
    out << line_of(*site, number - 1, options.fleet);
    if (!out.flush()) return fail(ErrorCode::unavailable, file + ": cannot be written; is --lines a folder?");
  }
  return {};
}

}  // namespace weft::light
