#include "agents/bodies/sim/hall/interior.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "agents/bodies/sim/hall/ceiling_surface.hpp"
#include "agents/bodies/sim/hall/overhead.hpp"
#include "agents/bodies/sim/hall/panels.hpp"
#include "agents/bodies/sim/hall/stock.hpp"
#include "core/geometry/pose3.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

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
    sign.contrast = 1.0F;
    sign.grey = static_cast<float>(random.uniform(90.0, 150.0));
    sign.pattern = static_cast<std::uint32_t>(random.next());
    quads.push_back(sign);
  }
}

void add_wall(const Quad& whole, Random random, std::vector<Quad>& quads) {
  add_panels(whole, quads);
  add_signs(whole, random, quads);
}

/// Adds a wall or a pillar of the site.
void add_upright(const Box& box, const Site& site, std::vector<Quad>& quads) {
  std::vector<Quad> sides;
  Quad look;
  look.grey = static_cast<float>(site.hall.wall_grey);
  look.contrast = static_cast<float>(box.contrast);
  const Pose2& pose = box.site_from_box;
  add_box({{pose.x, pose.y, 0.0}, pose.heading, box.length_m, box.width_m, box.height_m}, look, sides);
  for (const Quad& side : sides) {
    if (box.has_signs) {
      add_wall(side, Random(site.floor.seed ^ quads.size()), quads);
    } else {
      add_panels(side, quads);
    }
  }
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
  add_ceiling(site, face({x0, y0 + d, h}, across, -along, Stuff::ceiling, site.hall.ceiling_grey), quads);
  const Random walls(f.seed ^ 0x77616c6cULL);
  const double grey = site.hall.wall_grey;
  add_wall(face({x0, y0, 0}, along, up, Stuff::wall, grey), Random(walls).fork(1), quads);
  add_wall(face({x0 + w, y0, 0}, -across, up, Stuff::wall, grey), Random(walls).fork(2), quads);
  add_wall(face({x0 + w, y0 + d, 0}, -along, up, Stuff::wall, grey), Random(walls).fork(3), quads);
  add_wall(face({x0, y0 + d, 0}, across, up, Stuff::wall, grey), Random(walls).fork(4), quads);
}

/// Holds where the quads of a rack are among all.
struct RackQuads {
  Pose2 site_from_rack;
  std::size_t first, last;
};

/// Adds a rack that shows what another one does: the same quads at its own place.
void add_alike(const Box& rack, const RackQuads& other, std::vector<Quad>& quads) {
  const Pose3 here_from_there = lift(rack.site_from_box * other.site_from_rack.inverse());
  for (std::size_t i = other.first; i < other.last; ++i) {
    Quad quad = quads[i];
    quad.corner = (here_from_there * quad.corner.cast<double>()).cast<float>();
    quad.across = (here_from_there.rotation * quad.across.cast<double>()).cast<float>();
    quad.up = (here_from_there.rotation * quad.up.cast<double>()).cast<float>();
    quads.push_back(quad);
  }
}

}  // namespace

std::vector<Quad> interior_of(const Site& site) {
  std::vector<Quad> quads;
  add_shell(site, quads);
  add_overhead(site, quads);
  std::map<std::string, RackQuads> racks;
  for (const Box& box : site.boxes) {
    if (const auto other = racks.find(box.like); other != racks.end()) {
      add_alike(box, other->second, quads);
    } else if (box.kind == Box::Kind::rack) {
      const std::size_t first = quads.size();
      add_rack(box, site, quads);
      if (!box.name.empty()) racks.try_emplace(box.name, RackQuads{box.site_from_box, first, quads.size()});
    } else {
      add_upright(box, site, quads);
    }
  }
  return quads;
}

}  // namespace weft::agents::sim
