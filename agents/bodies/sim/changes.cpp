#include "agents/bodies/sim/changes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "agents/bodies/sim/floor/materials.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Error unknown(const std::string& what, const std::string& name, const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& known : names) list += (list.empty() ? "" : ", ") + known;
  return {ErrorCode::invalid, "no " + what + " \"" + name + "\"; there are " + list};
}

/// Calls `put` at one place in each square of the floor, so that a robot meets some wherever it drives; squares grow
/// where there would be more than a site file may list.
template <class Put>
void strew(const Site& site, double apart_m, std::uint64_t stream, Put&& put) {
  constexpr double kMost = 800.0;
  const double width = site.floor.x_max - site.floor.x_min;
  const double height = site.floor.y_max - site.floor.y_min;
  const double side = std::max(apart_m, std::sqrt(width * height / kMost));
  Random random = Random(site.change.seed).fork(stream);
  for (double y = site.floor.y_min; y < site.floor.y_max; y += side) {
    for (double x = site.floor.x_min; x < site.floor.x_max; x += side) {
      const double px = x + side * random.uniform(0.2, 0.8);
      const double py = y + side * random.uniform(0.2, 0.8);
      put(random, px, py);
    }
  }
}

void add_moving_shadows(Site& site) {
  strew(site, 5.0, 1, [&](Random& random, double x, double y) {
    CastShadow rack;
    rack.site_from_shadow = {x, y, random.uniform(-std::numbers::pi, std::numbers::pi)};
    rack.length_m = 2.7;
    rack.width_m = 1.1;
    rack.depth = 0.55;
    rack.soft_m = 0.15;
    rack.travel_m = 3.0;
    rack.speed_m_s = 0.4;
    rack.phase_rad = random.uniform(-std::numbers::pi, std::numbers::pi);
    site.change.shadows.push_back(rack);
  });
}

void add_pallets(Site& site) {
  strew(site, 3.0, 2, [&](Random& random, double x, double y) {
    CastShadow pallet;
    pallet.site_from_shadow = {x, y, random.uniform(-std::numbers::pi, std::numbers::pi)};
    pallet.soft_m = 0.1;
    site.change.shadows.push_back(pallet);
  });
}

void add_wet_areas(Site& site) {
  strew(site, 3.0, 3, [&](Random& random, double x, double y) {
    site.change.wet.push_back({x, y, random.uniform(0.3, 0.8)});
  });
}

/// Adds aisles painted along and across the hall.
void add_lines(Site& site) {
  constexpr double kApartM = 4.0;
  const FloorSetup& f = site.floor;
  const double apart = std::max(kApartM, std::max(f.x_max - f.x_min, f.y_max - f.y_min) / 400.0);
  for (double y = f.y_min + 0.4 * apart; y < f.y_max; y += apart) {
    site.change.lines.push_back({.x0 = f.x_min, .y0 = y, .x1 = f.x_max, .y1 = y});
  }
  for (double x = f.x_min + 0.4 * apart; x < f.x_max; x += apart) {
    site.change.lines.push_back({.x0 = x, .y0 = f.y_min, .x1 = x, .y1 = f.y_max});
  }
}

}  // namespace

const std::vector<std::string>& floor_kinds() {
  static const std::vector<std::string> names = {
      "polished-concrete", "worn-concrete", "epoxy", "tiles", "wood", "asphalt"};
  return names;
}

Result<Site> on_floor(Site site, const std::string& kind) {
  std::vector<std::string> names;
  for (const Material& material : materials()) names.push_back(material.name);
  if (!holds(names, kind)) return fail(unknown("floor", kind, names));
  site.floor.material = kind;
  return site;
}

const std::vector<std::string>& light_names() {
  static const std::vector<std::string> names = {"same", "halved", "moving-shadow", "glare", "coloured", "lens-dirt"};
  return names;
}

Result<Site> under_light(Site site, const std::string& name) {
  if (!holds(light_names(), name)) return fail(unknown("light", name, light_names()));
  if (name == "halved") site.change.light = 0.5;
  if (name == "moving-shadow") add_moving_shadows(site);
  if (name == "glare") {
    if (site.lamps.empty()) {
      return fail(ErrorCode::invalid,
                  "light \"glare\": site " + site.name + " has no [[lamp]] to be mirrored; give it one");
    }
    site.change.glare_grey = 160.0;
  }
  if (name == "coloured") site.change.light_warmth = 0.6;
  if (name == "lens-dirt") site.change.lens_spots = 14;
  return site;
}

const std::vector<std::string>& wear_names() {
  static const std::vector<std::string> names = {"same", "dirt", "wet", "line", "pallet"};
  return names;
}

Result<Site> with_wear(Site site, const std::string& name) {
  if (!holds(wear_names(), name)) return fail(unknown("wear", name, wear_names()));
  if (name == "dirt") site.change.dirt_per_m2 = 400.0;
  if (name == "wet") add_wet_areas(site);
  if (name == "line") add_lines(site);
  if (name == "pallet") add_pallets(site);
  return site;
}

}  // namespace weft::agents::sim
