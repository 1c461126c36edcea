#include "tests/simulation/aisles_course.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace weft::simulation {
namespace {

constexpr double kBulb = 1.5;   // radius of the turning place at an end of the aisle
constexpr double kCurve = 2.0;  // of all other curves
constexpr double kAside = 1.8;
constexpr double kOverlap = 1.5;
/// Lists where robots can stand at first: in no siding, and apart though the aisle comes by thrice.
constexpr std::array<double, 8> kStarts = {1.0, 9.0, 13.0, 33.0, 39.5, 58.0, 67.1, 88.5};

}  // namespace

void AislesCourse::add(double length_m, double turn_rad) {
  Bend bend{length_m, turn_rad, length_m_, {2.0, 0.0, 0.0}};
  if (!bends_.empty()) bend.start = at(length_m_);
  bends_.push_back(bend);
  length_m_ += length_m;
}

void AislesCourse::go(double metres) {
  add(metres, 0.0);
}

void AislesCourse::turn(double degrees, double radius_m) {
  const double angle = degrees * std::numbers::pi / 180.0;
  add(std::abs(angle) * radius_m, angle);
}

/// Leads back to where it began, the other way; a station at the far end.
void AislesCourse::turn_round() {
  turn(-60.0, kBulb);
  turn(300.0, kBulb);
  station(bends_.back().length_m / 2.0, kAside);
  turn(-60.0, kBulb);
}

void AislesCourse::station(double along_m, double right_m) {
  stations_.push_back({bends_.back().from_m + along_m, right_m});
}

/// x is east along the aisle, which reaches from (0, 0) to (16, 0); the course begins at (2, 0).
AislesCourse::AislesCourse() {
  go(14.0);
  station(8.0, 0.0);  // at (10, 0), eastwards
  turn_round();
  go(16.0);
  station(6.0, 0.0);  // at (10, 0), westwards
  turn_round();
  go(12.0);  // eastwards again, to (12, 0), where the crossing lane leaves
  turn(90.0, kCurve);
  go(3.0);
  turn(90.0, kCurve);
  go(4.0);  // at y = 7, westwards
  station(2.0, kAside);
  turn(90.0, kCurve);
  go(10.0);  // at x = 6, southwards, across the aisle
  station(2.0, kAside);
  turn(-90.0, kCurve);
  go(2.0);  // at y = -7, westwards
  station(1.0, -kAside);
  turn(-90.0, kCurve);
  go(3.0);  // at x = 0, northwards
  station(1.5, -kAside);
  turn(-90.0, kCurve);
}

Pose2 AislesCourse::at(double along_m) const {
  double rest = std::fmod(along_m, length_m_);
  if (rest < 0.0) rest += length_m_;
  if (along_m == length_m_) rest = length_m_;  // the end, not the beginning, while the course is being laid out
  auto bend = bends_.begin();
  while (rest > bend->from_m + bend->length_m && bend + 1 != bends_.end()) ++bend;
  const double share = (rest - bend->from_m) / bend->length_m;
  return bend->start * se2_exp({bend->length_m * share, 0.0, bend->turn_rad * share});
}

double AislesCourse::start_m(std::size_t robot, std::size_t robots) const {
  const std::size_t lap = robot / robots;
  return kStarts.at(robot % robots * kStarts.size() / robots) + static_cast<double>(lap) * length_m_;
}

/// Up to where the next one but one begins: every stretch is taught twice, once through its sidings and once past
/// them, by different robots where there are enough.
Lesson AislesCourse::lesson(std::size_t robot, std::size_t robots) const {
  const std::size_t parts = robots > 2 ? 2 : robots;
  Lesson lesson{start_m(robot, robots), start_m(robot + parts, robots) + kOverlap, {}};
  for (std::size_t k = 0; k < stations_.size(); ++k) {
    double at_m = stations_[k].at_m;
    if (at_m < lesson.from_m) at_m += length_m_;
    if (at_m < start_m(robot + 1, robots)) lesson.through.push_back(k);
  }
  return lesson;
}

}  // namespace weft::simulation
