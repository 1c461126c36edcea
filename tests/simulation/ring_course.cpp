#include "tests/simulation/ring_course.hpp"

#include <cmath>
#include <numbers>

namespace weft::simulation {
namespace {

constexpr double kLong = 27.0;   // straight part of the long sides
constexpr double kShort = 9.0;   // of the short sides
constexpr double kRadius = 1.5;  // of the corners
constexpr double kQuarter = kRadius * std::numbers::pi / 2.0;
constexpr double kAside = 1.8;
constexpr double kFirstStart = 9.0;
constexpr double kOverlap = 1.5;  // a lesson goes on past its beginning

/// Returns point and heading on one side of the ring and the corner that follows it.
Pose2 along_side(double at_m, double straight_m) {
  if (at_m <= straight_m) return {at_m, 0.0, 0.0};
  const double angle = (at_m - straight_m) / kRadius;
  return {straight_m + kRadius * std::sin(angle), kRadius * (1.0 - std::cos(angle)), angle};
}

}  // namespace

RingCourse::RingCourse() : length_m_(2.0 * (kLong + kShort) + 4.0 * kQuarter) {
  const double second = kLong + kQuarter;
  const double third = second + kShort + kQuarter;
  const double fourth = third + kLong + kQuarter;
  for (const double at : {4.5, 13.5, 22.5, second + 4.5, third + 4.5, third + 13.5, third + 22.5, fourth + 4.5})
    stations_.push_back({at, kAside});
}

Pose2 RingCourse::at(double along_m) const {
  double rest = std::fmod(along_m, length_m_);
  if (rest < 0.0) rest += length_m_;
  Pose2 start;
  for (const double straight : {kLong, kShort, kLong, kShort}) {
    if (rest <= straight + kQuarter) return start * along_side(rest, straight);
    rest -= straight + kQuarter;
    start = start * along_side(straight + kQuarter, straight);
  }
  return start;
}

double RingCourse::start_m(std::size_t robot, std::size_t robots) const {
  return kFirstStart + static_cast<double>(robot) * length_m_ / static_cast<double>(robots);
}

Lesson RingCourse::lesson(std::size_t robot, std::size_t robots) const {
  const double from = start_m(robot, robots);
  Lesson lesson{from, from + length_m_ + kOverlap, {}};
  for (std::size_t k = robot; k < stations_.size(); k += robots) lesson.through.push_back(k);
  return lesson;
}

}  // namespace weft::simulation
