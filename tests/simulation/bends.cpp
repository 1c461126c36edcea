#include "tests/simulation/bends.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace weft::simulation {

void Bends::add(double length_m, double turn_rad) {
  const Pose2 start = bends_.empty() ? start_ : at(Bends::length_m());
  bends_.push_back({length_m, turn_rad, Bends::length_m(), start});
}

void Bends::turn(double degrees, double radius_m) {
  const double angle = degrees * std::numbers::pi / 180.0;
  add(std::abs(angle) * radius_m, angle);
}

double Bends::turn_round(double radius_m) {
  turn(-60.0, radius_m);
  turn(300.0, radius_m);
  const double far_m = bends_.back().from_m + bends_.back().length_m / 2.0;
  turn(-60.0, radius_m);
  return far_m;
}

Pose2 Bends::at(double along_m) const {
  const auto after = std::upper_bound(bends_.begin(), bends_.end(), along_m,
                                      [](double at_m, const Bend& bend) { return at_m < bend.from_m; });
  const Bend& bend = after == bends_.begin() ? bends_.front() : *std::prev(after);
  const double share = (along_m - bend.from_m) / bend.length_m;
  return bend.start * se2_exp({bend.length_m * share, 0.0, bend.turn_rad * share});
}

Pose2 Bends::at_modulo(double along_m) const {
  const double whole_m = Bends::length_m();
  if (along_m == whole_m) return at(along_m);
  const double rest = std::fmod(along_m, whole_m);
  return at(rest < 0.0 ? rest + whole_m : rest);
}

}  // namespace weft::simulation
