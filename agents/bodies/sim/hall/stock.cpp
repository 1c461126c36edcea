#include "agents/bodies/sim/hall/stock.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kBayM = 2.7;
constexpr double kUprightM = 0.09;
constexpr double kBeamM = 0.11;
constexpr double kBoardM = 0.03;
constexpr double kPalletM = 0.144;
constexpr std::size_t kLoadsOfBay = 3;

std::uint64_t hash_of(std::string_view text) {
  std::uint64_t h = 0xcbf29ce484222325ULL;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 0x100000001b3ULL;
  return h;
}

Quad look(Stuff stuff, double grey, std::uint32_t pattern = 0) {
  Quad quad;
  quad.stuff = stuff;
  quad.grey = static_cast<float>(grey);
  quad.pattern = pattern;
  return quad;
}

/// Adds boxes that are placed in the rack's frame: x along it, y across.
class Rack {
 public:
  Rack(const Box& box, std::vector<Quad>& quads) : box_(box), quads_(quads) {}
  void add(double x, double y, double z, double length, double width, double height, const Quad& looks) {
    const Eigen::Vector2d at = box_.site_from_box * Eigen::Vector2d(x, y);
    add_box({{at.x(), at.y(), z}, box_.site_from_box.heading, length, width, height}, looks, quads_);
  }

 private:
  const Box& box_;
  std::vector<Quad>& quads_;
};

struct Slot {
  double x, z, width_m, height_m;
};

/// Adds what stands on one pallet's place, if anything.
void add_load(Rack& rack, const Box& box, const Slot& slot, Random random) {
  if (random.chance(0.12)) return;
  const double set_back = random.uniform(0.0, 0.12);
  const double depth = box.width_m - 0.1 - set_back;
  constexpr double least_m = 0.1;  // a rack for pipes and boards holds nothing else
  if (depth < least_m || slot.width_m < least_m) return;
  const double y = (random.chance(0.5) ? 0.5 : -0.5) * set_back;
  rack.add(slot.x, y, slot.z, slot.width_m, depth, kPalletM, look(Stuff::pallet, random.uniform(80.0, 120.0)));
  const double height = std::min(slot.height_m - kPalletM - 0.08, random.uniform(0.35, 1.3));
  if (height < 0.1) return;
  const double narrower = random.uniform(0.8, 1.0);
  rack.add(slot.x, y, slot.z + kPalletM, slot.width_m * narrower, depth * narrower, height,
           look(Stuff::load, random.uniform(85.0, 150.0), static_cast<std::uint32_t>(random.next())));
}

/// Returns the random numbers that decide on the load of a place: those of the rack, or of the last time that it
/// changed.
Random stocked(const Box& box, const Site& site, std::uint64_t place) {
  const Random of_change = Random(site.change.seed ^ hash_of(box.name));
  constexpr std::uint64_t times = 1ULL << 40U;  // beyond all places
  for (int time = site.change.stock_times; time >= 1; --time) {
    Random this_time = time == 1 ? of_change : Random(of_change).fork(times + static_cast<std::uint64_t>(time));
    Random changed = this_time.fork(place);
    if (changed.chance(site.change.stock)) return changed.fork(1);
  }
  return Random(site.floor.seed ^ hash_of(box.name)).fork(place);
}

}  // namespace

void add_rack(const Box& box, const Site& site, std::vector<Quad>& quads) {
  Rack rack(box, quads);
  const auto bays = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(box.length_m / kBayM)));
  const double bay_m = box.length_m / static_cast<double>(bays);
  const auto levels = std::max<std::size_t>(1, static_cast<std::size_t>(std::lround(box.height_m / 1.5)));
  const double level_m = box.height_m / static_cast<double>(levels);
  const Quad steel = look(Stuff::steel, 95.0);
  const Quad beam = look(Stuff::steel, 135.0);
  for (std::size_t bay = 0; bay <= bays; ++bay) {
    const double x = -box.length_m / 2 + bay_m * static_cast<double>(bay);
    for (const double side : {-0.5, 0.5})
      rack.add(x, side * (box.width_m - kUprightM), 0.0, kUprightM, kUprightM, box.height_m, steel);
    if (bay == bays) break;
    const double middle = x + bay_m / 2;
    for (std::size_t level = 0; level < levels; ++level) {
      const double z = level_m * static_cast<double>(level);
      if (level > 0) {
        for (const double side : {-0.5, 0.5})
          rack.add(middle, side * (box.width_m - 0.05), z - kBeamM, bay_m, 0.05, kBeamM, beam);
        rack.add(middle, 0.0, z - kBoardM, bay_m, box.width_m - 0.1, kBoardM, look(Stuff::pallet, 90.0));
      }
      const double pitch = (bay_m - kUprightM) / kLoadsOfBay;
      for (std::size_t load = 0; load < kLoadsOfBay; ++load) {
        const Slot slot{x + kUprightM / 2 + pitch * (static_cast<double>(load) + 0.5), z, 0.9 * pitch,
                        level_m - kBeamM};
        const std::uint64_t place = (bay * 64 + level) * 8 + load;
        add_load(rack, box, slot, stocked(box, site, place));
      }
    }
  }
}

}  // namespace weft::agents::sim
