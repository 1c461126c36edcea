#include "agents/bodies/sim/lamps.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

namespace weft::agents::sim {

std::vector<double> lamps_now(const Site& site, Random random) {
  std::vector<double> bright;
  for (std::size_t i = 0; i < site.lamps.size(); ++i)
    bright.push_back(1.0 + site.disturbances.light_change * random.uniform(-1.0, 1.0));
  std::vector<std::size_t> drawn(site.lamps.size());
  std::iota(drawn.begin(), drawn.end(), std::size_t{0});
  const auto lot = [&](std::size_t i) { return Random(site.change.seed).fork(i).uniform(0.0, 1.0); };
  std::stable_sort(drawn.begin(), drawn.end(), [&](std::size_t a, std::size_t b) { return lot(a) < lot(b); });
  const auto failed = std::lround(site.change.lamps_failed * static_cast<double>(drawn.size()));
  for (std::size_t i = 0; i < static_cast<std::size_t>(failed); ++i) bright[drawn[i]] = 0.0;
  return bright;
}

double share_at(const Lamp& lamp, double time_s) {
  if (time_s >= lamp.ends_s) return 0.0;
  if (lamp.flicker <= 0.0) return 1.0;
  const std::uint64_t place =
      std::bit_cast<std::uint64_t>(lamp.x) ^ std::rotl(std::bit_cast<std::uint64_t>(lamp.y), 17);
  const auto turn = static_cast<std::uint64_t>(std::max(0.0, time_s) * lamp.flicker_hz);
  return 1.0 - lamp.flicker * Random(place).fork(turn).uniform();
}

}  // namespace weft::agents::sim
