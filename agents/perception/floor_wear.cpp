#include "agents/perception/floor_wear.hpp"

#include <cmath>
#include <numbers>

#include "core/random.hpp"

namespace weft::agents {
namespace {

constexpr double pi = std::numbers::pi;

Pose2 anywhere(Random& random, double far_m) {
  return {random.uniform(0.0, far_m), random.uniform(-far_m, far_m), random.uniform(-pi, pi)};
}

/// Draws a speck 1 to 14 mm long, few of them large; most are darker than the floor.
Blot speck(Random& random, double far_m) {
  constexpr int corners = 8;
  const Pose2 at = anywhere(random, far_m);
  const double size = random.uniform();
  const double half_length_m = 0.0005 + 0.0065 * size * size;
  const double half_width_m = half_length_m * random.uniform(0.3, 1.0);
  Blot blot;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2.0 * pi * i / corners;
    blot.outline_on_floor.push_back(at *
                                    Eigen::Vector2d(half_length_m * std::cos(angle), half_width_m * std::sin(angle)));
  }
  blot.grey = random.uniform(-70.0, 35.0);
  return blot;
}

/// Adds the mark of a tyre: three ribs, side by side.
void mark(Random& random, double far_m, std::vector<Blot>& blots) {
  const Pose2 at = anywhere(random, far_m);
  const double length_m = random.uniform(0.2, 1.0);
  const double grey = random.uniform(-45.0, -15.0);
  for (const double left_m : {-0.022, 0.0, 0.022}) {
    const auto corner = [&](double along_m, double across_m) {
      return at * Eigen::Vector2d(along_m, left_m + across_m);
    };
    blots.push_back(
        {{corner(0.0, -0.007), corner(length_m, -0.007), corner(length_m, 0.007), corner(0.0, 0.007)}, grey});
  }
}

}  // namespace

std::vector<Blot> blots_of(const FloorWear& wear, std::uint64_t seed) {
  Random random(seed);
  const double area_m2 = 2.0 * wear.far_m * wear.far_m;
  std::vector<Blot> blots;
  for (int left = static_cast<int>(std::lround(wear.marks_per_m2 * area_m2)); left > 0; --left)
    mark(random, wear.far_m, blots);
  for (int left = static_cast<int>(std::lround(wear.specks_per_m2 * area_m2)); left > 0; --left)
    blots.push_back(speck(random, wear.far_m));
  return blots;
}

}  // namespace weft::agents
