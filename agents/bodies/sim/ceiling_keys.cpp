#include "agents/bodies/sim/ceiling_keys.hpp"

#include <cmath>
#include <numbers>

namespace weft::agents::sim {
namespace {

using config::required;
using config::Table;

constexpr double kReachM = 1000.0;    // no warehouse reaches further
constexpr double kLeastClearM = 1.5;  // under what hangs

/// Reads `from` and `to` of what is straight.
template <class Straight>
void read_ends(const Table& table, Straight& it) {
  const std::vector<double> from = table.numbers("from", required, 2, 2, -kReachM, kReachM);
  const std::vector<double> to = table.numbers("to", required, 2, 2, -kReachM, kReachM);
  if (from.size() != 2 || to.size() != 2) return;
  it.x0 = from[0];
  it.y0 = from[1];
  it.x1 = to[0];
  it.y1 = to[1];
  if (std::hypot(it.x1 - it.x0, it.y1 - it.y0) < 0.1) table.refuse("to", "must be at least 0.1 m from `from`");
}

/// Refuses what would hang down to `lowest_m` below the ceiling, in robots' way.
void check_clear(const Table& table, double lowest_m, double ceiling_m) {
  if (ceiling_m - lowest_m < kLeastClearM)
    table.refuse("below_m", "must leave 1.5 m of height under it, of hall.ceiling_m");
}

Pipe pipe_in(const Table& table, double ceiling_m) {
  Pipe p;
  read_ends(table, p);
  p.below_m = table.number("below_m", p.below_m, 0.02, 5.0);
  p.diameter_m = table.number("diameter_m", p.diameter_m, 0.02, 1.0);
  p.grey = table.number("grey", p.grey, 5.0, 250.0);
  check_clear(table, p.below_m + 0.5 * p.diameter_m, ceiling_m);
  return p;
}

Skylight skylight_in(const Table& table) {
  Skylight s;
  s.site_from_skylight.x = table.number("x", required, -kReachM, kReachM);
  s.site_from_skylight.y = table.number("y", required, -kReachM, kReachM);
  s.site_from_skylight.heading = std::numbers::pi / 180.0 * table.number("heading_deg", 0.0, -360.0, 360.0);
  s.length_m = table.number("length_m", s.length_m, 0.2, 50.0);
  s.width_m = table.number("width_m", s.width_m, 0.2, 50.0);
  s.brightness = table.number("brightness", s.brightness, 0.0, 20.0);
  return s;
}

void add_lamp_grid(const Table& table, Site& site) {
  Lamp lamp;
  const double x = table.number("x", required, -kReachM, kReachM);
  const double y = table.number("y", required, -kReachM, kReachM);
  const double apart_x = table.number("apart_x_m", required, 0.3, 50.0);
  const double apart_y = table.number("apart_y_m", required, 0.3, 50.0);
  const auto columns = table.integer("columns", required, 1, 100);
  const auto rows = table.integer("rows", required, 1, 100);
  read_shining(table, lamp);
  for (std::int64_t row = 0; row < rows; ++row) {
    for (std::int64_t column = 0; column < columns; ++column) {
      lamp.x = x + apart_x * static_cast<double>(column);
      lamp.y = y + apart_y * static_cast<double>(row);
      site.lamps.push_back(lamp);
    }
  }
}

}  // namespace

CeilingSetup ceiling_in(const Table& hall) {
  CeilingSetup c;
  const std::vector<std::string> kinds = {"plain", "bare", "concrete", "sheet", "panels"};  // in the enum's order
  const std::string kind = hall.choice("ceiling", kinds.front(), kinds);
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (kinds[i] == kind) c.kind = static_cast<CeilingKind>(i);
  const auto apart = [&hall](const char* key, double fallback) {
    const double apart_m = hall.number(key, fallback, 0.0, 100.0);
    if (apart_m > 0.0 && apart_m < 0.5) hall.refuse(key, "must be 0, for none, or at least 0.5");
    return apart_m;
  };
  c.beams_every_m = apart("beams_every_m", c.beams_every_m);
  c.sprinklers_every_m = apart("sprinklers_every_m", c.sprinklers_every_m);
  c.signs_every_m = apart("signs_every_m", c.signs_every_m);
  c.dirt = hall.number("dirt", c.dirt, 0.0, 5.0);
  c.stains_per_m2 = hall.number("stains_per_m2", c.stains_per_m2, 0.0, 5.0);
  c.lamp_length_m = hall.number("lamp_length_m", c.lamp_length_m, 0.05, 10.0);
  c.lamp_width_m = hall.number("lamp_width_m", c.lamp_width_m, 0.05, 10.0);
  return c;
}

Duct duct_in(const Table& table, double ceiling_m) {
  Duct d;
  read_ends(table, d);
  d.below_m = table.number("below_m", d.below_m, 0.0, 5.0);
  d.width_m = table.number("width_m", d.width_m, 0.05, 3.0);
  d.height_m = table.number("height_m", d.height_m, 0.05, 3.0);
  d.grey = table.number("grey", d.grey, 5.0, 250.0);
  check_clear(table, d.below_m + d.height_m, ceiling_m);
  return d;
}

void read_shining(const Table& table, Lamp& lamp) {
  constexpr double longest_s = 1e6;
  lamp.height_m = table.number("height_m", lamp.height_m, 2.0, 30.0);
  lamp.brightness = table.number("brightness", lamp.brightness, 0.0, 20.0);
  lamp.flicker = 0.01 * table.number("flicker_percent", 100 * lamp.flicker, 0.0, 100.0);
  lamp.flicker_hz = table.number("flicker_hz", lamp.flicker_hz, 0.1, 50.0);
  if (table.has("ends_s")) lamp.ends_s = table.number("ends_s", required, 0.0, longest_s);
}

void add_overhead_in(const Table& root, Site& site) {
  const double ceiling_m = site.hall.ceiling_m;
  for (const Table& table : root.tables("duct", 0, 1000)) site.ducts.push_back(duct_in(table, ceiling_m));
  for (const Table& table : root.tables("pipe", 0, 1000)) site.pipes.push_back(pipe_in(table, ceiling_m));
  for (const Table& table : root.tables("skylight", 0, 1000)) site.skylights.push_back(skylight_in(table));
  for (const Table& table : root.tables("lamp_grid", 0, 100)) add_lamp_grid(table, site);
}

}  // namespace weft::agents::sim
