#include "agents/bodies/sim/change_keys.hpp"

#include <cmath>
#include <numbers>

#include "agents/bodies/sim/ceiling_keys.hpp"

namespace weft::agents::sim {
namespace {

using config::required;
using config::Table;

constexpr double kSiteReachM = 1000.0;  // metres: no warehouse reaches further
constexpr double kRadPerDegree = std::numbers::pi / 180.0;

CastShadow shadow_in(const Table& table) {
  CastShadow s;
  s.site_from_shadow.x = table.number("x", required, -kSiteReachM, kSiteReachM);
  s.site_from_shadow.y = table.number("y", required, -kSiteReachM, kSiteReachM);
  s.site_from_shadow.heading = kRadPerDegree * table.number("heading_deg", 0.0, -360.0, 360.0);
  s.length_m = table.number("length_m", s.length_m, 0.05, 50.0);
  s.width_m = table.number("width_m", s.width_m, 0.05, 50.0);
  s.depth = 0.01 * table.number("depth_percent", 100 * s.depth, 0.0, 100.0);
  s.soft_m = table.number("soft_m", s.soft_m, 0.05, 2.0);
  s.travel_m = table.number("travel_m", s.travel_m, 0.0, 100.0);
  s.speed_m_s = table.number("speed_m_s", s.speed_m_s, 0.0, 5.0);
  s.phase_rad = kRadPerDegree * table.number("phase_deg", 0.0, -360.0, 360.0);
  return s;
}

WetArea wet_in(const Table& table) {
  WetArea w;
  w.x = table.number("x", required, -kSiteReachM, kSiteReachM);
  w.y = table.number("y", required, -kSiteReachM, kSiteReachM);
  w.radius_m = table.number("radius_m", w.radius_m, 0.1, 10.0);
  return w;
}

PaintedLine line_in(const Table& table) {
  PaintedLine l;
  const std::vector<double> from = table.numbers("from", required, 2, 2, -kSiteReachM, kSiteReachM);
  const std::vector<double> to = table.numbers("to", required, 2, 2, -kSiteReachM, kSiteReachM);
  if (from.size() == 2 && to.size() == 2) {
    l.x0 = from[0];
    l.y0 = from[1];
    l.x1 = to[0];
    l.y1 = to[1];
    if (std::hypot(l.x1 - l.x0, l.y1 - l.y0) < 0.1) table.refuse("to", "must be at least 0.1 m from `from`");
  }
  l.width_m = table.number("width_m", l.width_m, 0.02, 2.0);
  l.grey = table.number("grey", l.grey, 0.0, 255.0);
  l.warmth = table.number("warmth", l.warmth, -1.0, 1.0);
  return l;
}

}  // namespace

Change change_in(const Table& table, Change c, double ceiling_m) {
  c.from_day = static_cast<std::uint64_t>(table.integer("from_day", 0, 0, INT64_MAX));
  c.light = 0.01 * table.number("light_percent", 100 * c.light, 5.0, 400.0);
  c.light_warmth = table.number("light_warmth", c.light_warmth, -1.0, 1.0);
  c.glare_grey = table.number("glare_grey", c.glare_grey, 0.0, 500.0);
  c.glare_size_m = table.number("glare_size_m", c.glare_size_m, 0.1, 3.0);
  c.lens_spots = static_cast<int>(table.integer("lens_spots", c.lens_spots, 0, 200));
  c.lens_depth = 0.01 * table.number("lens_depth_percent", 100 * c.lens_depth, 0.0, 100.0);
  c.dirt_per_m2 = table.number("dirt_per_m2", c.dirt_per_m2, 0.0, 5000.0);
  c.stock = 0.01 * table.number("stock_percent", 100 * c.stock, 0.0, 100.0);
  c.stock_times = static_cast<int>(table.integer("stock_times", c.stock_times, 1, 1000));
  c.lamps_failed = 0.01 * table.number("lamps_failed_percent", 100 * c.lamps_failed, 0.0, 100.0);
  c.ambient = 0.01 * table.number("ambient_percent", 100 * c.ambient, 0.0, 100.0);
  c.skylight = 0.01 * table.number("skylight_percent", 100 * c.skylight, 0.0, 10'000.0);
  c.sinks_m = 1e-3 * table.number("sinks_mm", 1e3 * c.sinks_m, 0.0, 100.0);
  for (const Table& each : table.tables("shadow", 0, 1000)) c.shadows.push_back(shadow_in(each));
  for (const Table& each : table.tables("wet", 0, 1000)) c.wet.push_back(wet_in(each));
  for (const Table& each : table.tables("line", 0, 1000)) c.lines.push_back(line_in(each));
  for (const Table& each : table.tables("duct", 0, 100)) c.ducts.push_back(duct_in(each, ceiling_m));
  return c;
}

}  // namespace weft::agents::sim
