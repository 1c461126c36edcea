#include "tests/simulation/aisles_course.hpp"

#include <array>

namespace weft::simulation {
namespace {

constexpr double kBulb = 1.5;   // radius of the turning place at an end of the aisle
constexpr double kCurve = 2.0;  // of all other curves
constexpr double kStationAside = 1.8;
constexpr double kLessonOverlap = 1.5;
/// Lists where robots can stand at first: in no siding, and apart though the aisle comes by thrice.
constexpr std::array<double, 8> kStarts = {1.0, 9.0, 13.0, 33.0, 39.5, 58.0, 67.1, 88.5};

}  // namespace

/// Lays the course out. x is east along the aisle, from (0, 0) to (16, 0); the course begins at (2, 0).
AislesCourse::AislesCourse() : bends_({2.0, 0.0, 0.0}) {
  const auto go = [&](double metres) { bends_.go(metres); };
  const auto turn = [&](double degrees) { bends_.turn(degrees, kCurve); };
  const auto station_back = [&](double metres, double right_m) { station(bends_.length_m() - metres, right_m); };
  go(14.0);
  station_back(6.0, 0.0);  // at (10, 0), eastwards
  station(bends_.turn_round(kBulb), kStationAside);
  go(16.0);
  station_back(10.0, 0.0);  // at (10, 0), westwards
  station(bends_.turn_round(kBulb), kStationAside);
  go(12.0);  // eastwards again, to (12, 0), where the crossing lane leaves
  turn(90.0);
  go(3.0);
  turn(90.0);
  go(4.0);  // at y = 7, westwards
  station_back(2.0, kStationAside);
  turn(90.0);
  go(10.0);  // at x = 6, southwards, across the aisle
  station_back(8.0, kStationAside);
  turn(-90.0);
  go(2.0);  // at y = -7, westwards
  station_back(1.0, -kStationAside);
  turn(-90.0);
  go(3.0);  // at x = 0, northwards
  station_back(1.5, -kStationAside);
  turn(-90.0);
}

double AislesCourse::start_m(std::size_t robot, std::size_t robots) const {
  const std::size_t lap = robot / robots;
  return kStarts.at(robot % robots * kStarts.size() / robots) + static_cast<double>(lap) * length_m();
}

/// Returns a stretch up to where the next lesson but one begins: every stretch is taught twice, once through its
/// sidings and once past them, by different robots where there are enough.
Lesson AislesCourse::lesson(std::size_t robot, std::size_t robots) const {
  const std::size_t parts = robots > 2 ? 2 : robots;
  Lesson lesson{start_m(robot, robots), start_m(robot + parts, robots) + kLessonOverlap, {}};
  for (std::size_t k = 0; k < stations_.size(); ++k) {
    double at_m = stations_[k].at_m;
    if (at_m < lesson.from_m) at_m += length_m();
    if (at_m < start_m(robot + 1, robots)) lesson.through.push_back(k);
  }
  return lesson;
}

}  // namespace weft::simulation
