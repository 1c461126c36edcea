#include "tests/simulation/grid_course.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace weft::simulation {
namespace {

constexpr double kAisle_m = 8.0;       // from crossing to crossing
constexpr double kCurve_m = 1.5;       // radius of a turn at a crossing
constexpr double kDeadEnd_m = 6.0;     // from the crossing to where it turns round
constexpr double kBulb_m = 0.7;        // radius there: nobody comes by
constexpr double kEachRobot_m = 28.0;  // of aisles
constexpr std::size_t kFewest = 3;     // crossings along a side
constexpr std::size_t kSides = 4;
constexpr std::size_t kDeadEndEach = 2;  // crossing along the northern and southern side

std::size_t opposite(std::size_t side) {
  return (side + 2) % kSides;
}

}  // namespace

/// Lays so many crossings that the aisles are long enough together: each crossing comes with two aisles.
GridCourse::GridCourse(std::size_t robots) : bends_({kCurve_m, 0.0, 0.0}) {
  const double crossings = static_cast<double>(robots) * kEachRobot_m / (2.0 * kAisle_m);
  columns_ = std::max(kFewest, static_cast<std::size_t>(std::ceil(std::sqrt(crossings))) + 1);
  rows_ = std::max(kFewest, static_cast<std::size_t>(std::ceil(crossings / static_cast<double>(columns_))));
  lay(circuit());
}

double GridCourse::east_m() const {
  return kAisle_m * static_cast<double>(columns_ - 1);
}

double GridCourse::north_m() const {
  return kAisle_m * static_cast<double>(rows_ - 1);
}

bool GridCourse::ends_dead(const Arm& arm) const {
  const std::size_t column = arm.crossing % columns_;
  const std::size_t row = arm.crossing / columns_;
  const bool is_outward[kSides] = {column + 1 == columns_, row + 1 == rows_, column == 0, row == 0};
  return is_outward[arm.side];
}

bool GridCourse::is_dead_end(const Arm& arm) const {
  const std::size_t column = arm.crossing % columns_;
  const bool is_along = arm.side % 2 == 1 && column > 0 && column + 1 < columns_;
  return ends_dead(arm) && is_along && column % kDeadEndEach == 1;
}

/// Returns the arm by which a robot arrives that leaves by this one; at a dead end the same.
GridCourse::Arm GridCourse::other_end(const Arm& arm) const {
  if (ends_dead(arm)) return arm;
  const std::size_t next[kSides] = {arm.crossing + 1, arm.crossing + columns_, arm.crossing - 1,
                                    arm.crossing - columns_};
  return {next[arm.side], opposite(arm.side)};
}

/// Returns the two sides by which a robot goes on that has arrived by that arm, never that arm's own. Every arm of a
/// crossing is left as often as it is arrived by.
std::vector<std::size_t> GridCourse::ways_on(const Arm& arrived) const {
  std::vector<std::size_t> sides;
  for (std::size_t turn = 1; turn < kSides; ++turn) {
    const std::size_t side = (arrived.side + turn) % kSides;
    if (has({arrived.crossing, side})) sides.push_back(side);
  }
  if (sides.size() == 1) return {sides[0], sides[0]};
  if (sides.size() == 2) return sides;
  const bool is_even = (arrived.crossing % columns_ + arrived.crossing / columns_) % 2 == 0;
  return {sides[1], is_even ? sides[0] : sides[2]};
}

std::vector<GridCourse::Arm> GridCourse::arms() const {
  std::vector<Arm> all;
  for (std::size_t crossing = 0; crossing < columns_ * rows_; ++crossing) {
    for (std::size_t side = 0; side < kSides; ++side) {
      if (has({crossing, side})) all.push_back({crossing, side});
    }
  }
  return all;
}

/// Returns the arms that are arrived by, in the order of a closed way that takes every way on once (Hierholzer
/// 1873).
std::vector<GridCourse::Arm> GridCourse::circuit() const {
  std::map<Arm, std::vector<std::size_t>> left;
  for (const Arm& arm : arms()) left[arm] = ways_on(arm);
  std::vector<Arm> path = {{1, 2}};
  std::vector<Arm> closed;
  while (!path.empty()) {
    std::vector<std::size_t>& ways = left.at(path.back());
    if (ways.empty()) {
      closed.push_back(path.back());
      path.pop_back();
      continue;
    }
    const Arm leaves{path.back().crossing, ways.back()};
    ways.pop_back();
    path.push_back(other_end(leaves));
  }
  std::reverse(closed.begin(), closed.end());
  return closed;
}

/// Lays the way, which begins in the southern aisle, eastwards, where the curve at the first crossing ends.
void GridCourse::lay(const std::vector<Arm>& circuit) {
  constexpr double between_m = kAisle_m - 2.0 * kCurve_m;
  std::set<std::set<Arm>> passed;
  std::size_t middles = 0;
  for (std::size_t i = 0; i + 1 < circuit.size(); ++i) {
    const Arm& arrived = circuit[i];
    // Names the arm by which the crossing is left: the one that leads to where the next one is arrived at.
    const Arm leaves = ends_dead(circuit[i + 1]) ? circuit[i + 1] : other_end(circuit[i + 1]);
    const std::size_t turn = (leaves.side + kSides - arrived.side) % kSides;
    if (i == 0) bends_.go(between_m);
    if (turn == 2) bends_.go(2.0 * kCurve_m);
    if (turn != 2) bends_.turn(turn == 1 ? -90.0 : 90.0, kCurve_m);
    const bool is_new = passed.insert({leaves, circuit[i + 1]}).second;
    if (ends_dead(leaves)) {
      bends_.go(kDeadEnd_m - kCurve_m);
      const double far_m = bends_.turn_round(kBulb_m);
      bends_.go(kDeadEnd_m - kCurve_m);
      if (is_new) stations_.push_back({far_m, 0.0});
      dead_ends_ += is_new ? 1 : 0;
      continue;
    }
    if (i + 2 == circuit.size()) continue;  // as it began
    bends_.go(between_m);
    if (!is_new) continue;
    const double middle_m = bends_.length_m() - between_m / 2.0;
    if (++middles % 2 == 0) starts_.push_back(middle_m);
    if (middles % 2 == 1) stations_.push_back({middle_m, 0.0});
  }
}

double GridCourse::start_m(std::size_t robot, std::size_t robots) const {
  return starts_.at(robot % robots * starts_.size() / robots);
}

Lesson GridCourse::lesson(std::size_t robot, std::size_t robots) const {
  Lesson lesson{start_m(robot, robots), start_m(robot, robots) + length_m(), {}};
  for (std::size_t k = 0; k < stations_.size(); ++k) lesson.through.push_back(k);
  return lesson;
}

}  // namespace weft::simulation
