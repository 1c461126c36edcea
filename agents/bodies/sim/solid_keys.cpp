#include "agents/bodies/sim/solid_keys.hpp"

#include <cmath>
#include <numbers>

namespace weft::agents::sim {
namespace {

using config::Table;

constexpr double kFarthestSolidM = 1000.0;
constexpr double kLatestSolidS = 1e6;

/// Returns the name of a thing, or what it is and its number.
std::string name_in(const Table& table, const std::string& what, std::size_t number) {
  return table.text("name", what + " " + std::to_string(number));
}

Mover mover_in(const Table& table, Mover::Kind kind) {
  Mover m;
  m.kind = kind;
  const std::vector<double> way = table.numbers("way", config::required, 4, 200, -kFarthestSolidM, kFarthestSolidM);
  if (way.size() % 2 != 0) table.refuse("way", "must hold an x and a y for each point");
  for (std::size_t i = 0; i + 1 < way.size(); i += 2) m.way.push_back({way[i], way[i + 1]});
  for (std::size_t i = 1; i < m.way.size(); ++i) {
    if (std::hypot(m.way[i].x - m.way[i - 1].x, m.way[i].y - m.way[i - 1].y) < 0.1)
      table.refuse("way", "has two points that are less than 0.1 m apart");
  }
  m.speed_m_s = table.number("speed_m_s", kind == Mover::Kind::person ? 1.0 : 1.5, 0.0, 5.0);
  m.begins_m = table.number("begins_m", 0.0, 0.0, 10'000.0);
  m.is_solid = table.boolean("solid", m.is_solid);
  if (kind == Mover::Kind::person) m.is_rude = table.boolean("rude", m.is_rude);
  if (kind == Mover::Kind::forklift) m.forks_m = table.number("forks_m", m.forks_m, m.forks_m, 12.0);
  return m;
}

/// Reads or sets how large an obstacle is: people and pallet jacks are as large as they are.
void read_size(const Table& table, Obstacle& o) {
  if (o.kind == Obstacle::Kind::crate) {
    o.length_m = table.number("length_m", o.length_m, 0.1, 5.0);
    o.width_m = table.number("width_m", o.width_m, 0.1, 5.0);
    o.height_m = table.number("height_m", o.height_m, 0.05, 5.0);
  } else if (o.kind == Obstacle::Kind::person) {
    o.length_m = 0.3;
    o.width_m = 0.64;
    o.height_m = 1.74;
  } else {
    o.length_m = 1.6;
    o.width_m = 0.55;
    o.height_m = 1.2;
  }
}

Obstacle obstacle_in(const Table& table) {
  const std::vector<std::string> kinds = {"crate", "person", "pallet-jack"};  // in the enum's order
  Obstacle o;
  const std::string kind = table.choice("kind", kinds.front(), kinds);
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (kinds[i] == kind) o.kind = static_cast<Obstacle::Kind>(i);
  o.site_from_obstacle.x = table.number("x", config::required, -kFarthestSolidM, kFarthestSolidM);
  o.site_from_obstacle.y = table.number("y", config::required, -kFarthestSolidM, kFarthestSolidM);
  o.site_from_obstacle.heading = std::numbers::pi / 180.0 * table.number("heading_deg", 0.0, -360.0, 360.0);
  read_size(table, o);
  o.from_day = static_cast<std::uint64_t>(table.integer("from_day", 0, 0, INT64_MAX));
  o.from_s = table.number("from_s", o.from_s, 0.0, kLatestSolidS);
  if (table.has("to_s")) o.to_s = table.number("to_s", config::required, 0.0, kLatestSolidS);
  if (o.to_s <= o.from_s) table.refuse("to_s", "must be greater than from_s");
  return o;
}

}  // namespace

void add_solids_in(const Table& root, Site& site) {
  const auto add_movers = [&](const std::string& what, Mover::Kind kind) {
    std::size_t number = 0;
    for (const Table& table : root.tables(what, 0, 100)) {
      site.movers.push_back(mover_in(table, kind));
      site.movers.back().name = name_in(table, what, ++number);
    }
  };
  add_movers("person", Mover::Kind::person);
  add_movers("forklift", Mover::Kind::forklift);
  for (const Table& table : root.tables("obstacle", 0, 1000)) {
    site.obstacles.push_back(obstacle_in(table));
    site.obstacles.back().name = name_in(table, "obstacle", site.obstacles.size());
  }
}

}  // namespace weft::agents::sim
