#include "agents/bodies/sim/hall/interior.hpp"

#include <algorithm>
#include <cmath>

#include "agents/bodies/sim/hall/stock.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kPanelM = 2.0;
constexpr double kBeyondM = 1.0;  // of the bounds, where the hall's own walls stand

/// Cuts a large face into panels, each of another piece of its texture: light is told at their corners.
void add_panels(const Quad& whole, std::vector<Quad>& quads) {
  const auto columns = std::max(1, static_cast<int>(std::ceil(whole.across.norm() / kPanelM)));
  const auto rows = std::max(1, static_cast<int>(std::ceil(whole.up.norm() / kPanelM)));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      Quad panel = whole;
      panel.across = whole.across / static_cast<float>(columns);
      panel.up = whole.up / static_cast<float>(rows);
      panel.corner = whole.corner + static_cast<float>(column) * panel.across + static_cast<float>(row) * panel.up;
      panel.pattern = static_cast<std::uint32_t>(quads.size());
      quads.push_back(panel);
    }
  }
}

Quad face(const Eigen::Vector3d& corner, const Eigen::Vector3d& across, const Eigen::Vector3d& up, Stuff stuff,
          double grey) {
  Quad quad;
  quad.corner = corner.cast<float>();
  quad.across = across.cast<float>();
  quad.up = up.cast<float>();
  quad.stuff = stuff;
  quad.grey = static_cast<float>(grey);
  return quad;
}

/// Adds signs, doors and panels on a wall face, a centimetre before it, no higher than 3.5 m.
void add_signs(const Quad& wall, Random random, std::vector<Quad>& quads) {
  const double length = wall.across.norm();
  const double height = std::min(3.5, static_cast<double>(wall.up.norm()));
  const Eigen::Vector3f before = 0.01F * wall.normal();
  const auto count = static_cast<int>(length * height * 0.12);
  for (int i = 0; i < count; ++i) {
    const double size = random.uniform(0.3, 0.9);
    if (length < size || height < size) continue;
    const auto x = static_cast<float>(random.uniform(0.0, length - size) / length);
    const auto z = static_cast<float>(random.uniform(0.0, height - size) / wall.up.norm());
    Quad sign = wall;
    sign.corner = wall.at(x, z) + before;
    sign.across = wall.across * static_cast<float>(size / length);
    sign.up = wall.up * static_cast<float>(random.uniform(0.7, 1.0) * size / wall.up.norm());
    sign.stuff = Stuff::sign;
    sign.grey = static_cast<float>(random.uniform(90.0, 150.0));
    sign.pattern = static_cast<std::uint32_t>(random.next());
    quads.push_back(sign);
  }
}

void add_wall(const Quad& whole, Random random, std::vector<Quad>& quads) {
  add_panels(whole, quads);
  add_signs(whole, random, quads);
}

void add_shell(const Site& site, std::vector<Quad>& quads) {
  const FloorSetup& f = site.floor;
  const double x0 = f.x_min - kBeyondM;
  const double y0 = f.y_min - kBeyondM;
  const double w = f.x_max - f.x_min + 2 * kBeyondM;
  const double d = f.y_max - f.y_min + 2 * kBeyondM;
  const double h = site.hall.ceiling_m;
  const Eigen::Vector3d across(w, 0, 0);
  const Eigen::Vector3d along(0, d, 0);
  const Eigen::Vector3d up(0, 0, h);
  add_panels(face({x0, y0, 0}, across, along, Stuff::floor, f.brightness), quads);
  add_panels(face({x0, y0 + d, h}, across, -along, Stuff::ceiling, site.hall.ceiling_grey), quads);
  const Random walls(f.seed ^ 0x77616c6cULL);
  const double grey = site.hall.wall_grey;
  add_wall(face({x0, y0, 0}, along, up, Stuff::wall, grey), Random(walls).fork(1), quads);
  add_wall(face({x0 + w, y0, 0}, -across, up, Stuff::wall, grey), Random(walls).fork(2), quads);
  add_wall(face({x0 + w, y0 + d, 0}, -along, up, Stuff::wall, grey), Random(walls).fork(3), quads);
  add_wall(face({x0, y0 + d, 0}, across, up, Stuff::wall, grey), Random(walls).fork(4), quads);
}

/// Adds beams across the hall every five metres, and the lamps' boxes.
void add_overhead(const Site& site, std::vector<Quad>& quads) {
  const FloorSetup& f = site.floor;
  Quad beam;
  beam.stuff = Stuff::steel;
  beam.grey = 85.0F;
  for (double x = f.x_min + 2.5; x < f.x_max; x += 5.0)
    add_box({{x, 0.5 * (f.y_min + f.y_max), site.hall.ceiling_m - 0.35},
             0.0,
             0.2,
             f.y_max - f.y_min + 2 * kBeyondM,
             0.35},
            beam, quads);
  for (const Lamp& lamp : site.lamps) {
    const double z = std::min(lamp.height_m, site.hall.ceiling_m - 0.05);
    const Eigen::Vector3d corner(lamp.x - 0.6, lamp.y + 0.15, z);
    quads.push_back(face(corner, {1.2, 0, 0}, {0, -0.3, 0}, Stuff::lamp, 128.0));
  }
}

}  // namespace

std::vector<Quad> interior_of(const Site& site) {
  std::vector<Quad> quads;
  add_shell(site, quads);
  add_overhead(site, quads);
  for (const Box& box : site.boxes) {
    if (box.kind == Box::Kind::rack) {
      add_rack(box, site, quads);
      continue;
    }
    std::vector<Quad> sides;
    Quad look;
    look.grey = static_cast<float>(site.hall.wall_grey);
    const Pose2& pose = box.site_from_box;
    add_box({{pose.x, pose.y, 0.0}, pose.heading, box.length_m, box.width_m, box.height_m}, look, sides);
    for (const Quad& side : sides) add_wall(side, Random(site.floor.seed ^ quads.size()), quads);
  }
  return quads;
}

}  // namespace weft::agents::sim
