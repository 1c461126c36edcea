#include "agents/bodies/sim/hall/overhead.hpp"

#include <algorithm>
#include <cmath>

#include "agents/bodies/sim/hall/panels.hpp"
#include "agents/bodies/sim/hall/services.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kGirderHighM = 0.35;

/// Adds beams across the hall, as high as the hall.
void add_beams(const Site& site, std::vector<Quad>& quads) {
  const FloorSetup& f = site.floor;
  const double apart_m = site.hall.ceiling.beams_every_m;
  if (apart_m <= 0.0) return;
  Quad beam;
  beam.stuff = Stuff::steel;
  beam.grey = 85.0F;
  for (double x = f.x_min + 0.5 * apart_m; x < f.x_max; x += apart_m)
    add_box({{x, 0.5 * (f.y_min + f.y_max), site.hall.ceiling_m - kGirderHighM},
             0.0,
             0.2,
             f.y_max - f.y_min + 2 * kBeyondM,
             kGirderHighM},
            beam, quads);
}

/// Adds beams that may be looked at from below: a web between two flanges, in pieces.
void add_girders(const Site& site, std::vector<Quad>& quads) {
  constexpr double piece_m = 3.0;
  constexpr double flange_m = 0.02;
  const FloorSetup& f = site.floor;
  const double apart_m = site.hall.ceiling.beams_every_m;
  if (apart_m <= 0.0) return;
  Quad look;
  look.stuff = Stuff::duct;
  look.grey = 85.0F;
  const double depth = f.y_max - f.y_min + 2 * kBeyondM;
  const auto pieces = static_cast<int>(std::ceil(depth / piece_m));
  const double bottom_m = site.hall.ceiling_m - kGirderHighM;
  for (double x = f.x_min + 0.5 * apart_m; x < f.x_max; x += apart_m) {
    for (int i = 0; i < pieces; ++i) {
      const double y = f.y_min - kBeyondM + (i + 0.5) * depth / pieces;
      add_closed_box({{x, y, bottom_m}, 0.0, 0.2, depth / pieces, flange_m}, look, quads);
      add_box({{x, y, bottom_m + flange_m}, 0.0, 0.012, depth / pieces, kGirderHighM - flange_m}, look, quads);
    }
  }
}

void add_lamps(const Site& site, std::vector<Quad>& quads) {
  const double length = site.hall.ceiling.lamp_length_m;
  const double width = site.hall.ceiling.lamp_width_m;
  for (const Lamp& lamp : site.lamps) {
    const double z = std::min(lamp.height_m, site.hall.ceiling_m - 0.05);
    const Eigen::Vector3d corner(lamp.x - 0.5 * length, lamp.y + 0.5 * width, z);
    quads.push_back(face(corner, {length, 0, 0}, {0, -width, 0}, Stuff::lamp, 128.0));
  }
}

/// Calls `put` near the crossings of a grid over the floor.
template <class Put>
void at_crossings(const Site& site, double apart_m, double aside_m, std::uint64_t stream, Put&& put) {
  if (apart_m <= 0.0) return;
  Random random = Random(site.floor.seed ^ 0x6f766572ULL).fork(stream);
  for (double y = site.floor.y_min + 0.5 * apart_m; y < site.floor.y_max; y += apart_m) {
    for (double x = site.floor.x_min + 0.4 * apart_m; x < site.floor.x_max; x += apart_m) {
      const double at_x = x + random.uniform(-aside_m, aside_m);
      const double at_y = y + random.uniform(-aside_m, aside_m);
      put(random, at_x, at_y);
    }
  }
}

}  // namespace

bool is_seen_from_below(const Site& site) {
  return std::any_of(site.robots.begin(), site.robots.end(), [](const RobotStart& robot) {
    return std::find(robot.looks.begin(), robot.looks.end(), Gaze::up) != robot.looks.end();
  });
}

void add_overhead(const Site& site, std::vector<Quad>& quads) {
  if (is_seen_from_below(site)) {
    add_girders(site, quads);
  } else {
    add_beams(site, quads);
  }
  add_lamps(site, quads);
  const double ceiling_m = site.hall.ceiling_m;
  for (const Duct& duct : site.ducts) add_duct(duct, ceiling_m, quads);
  for (const Duct& duct : site.change.ducts) add_duct(duct, ceiling_m, quads);
  for (const Pipe& pipe : site.pipes) add_pipe(pipe, ceiling_m, quads);
  for (const Skylight& skylight : site.skylights) add_skylight(skylight, ceiling_m, quads);
  const CeilingSetup& ceiling = site.hall.ceiling;
  at_crossings(site, ceiling.sprinklers_every_m, 0.1, 1,
               [&](Random&, double x, double y) { add_sprinkler(x, y, ceiling_m, quads); });
  at_crossings(site, ceiling.signs_every_m, 0.2 * ceiling.signs_every_m, 2,
               [&](Random& random, double x, double y) { add_hanging_sign(x, y, ceiling_m, random, quads); });
}

}  // namespace weft::agents::sim
