#include "agents/perception/particles/resampling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "agents/perception/particles/pose_cells.hpp"

namespace weft::agents {

std::size_t kld_count(const KldConfig& config, std::size_t cells) {
  const auto least = static_cast<std::size_t>(config.least);
  const auto most = static_cast<std::size_t>(config.most);
  if (cells < 2) return least;
  const auto free = static_cast<double>(cells - 1);
  const double part = 2.0 / (9.0 * free);
  const double root = 1.0 - part + std::sqrt(part) * config.z;
  const double count = std::ceil(free / (2.0 * config.epsilon) * root * root * root);
  return std::clamp(static_cast<std::size_t>(count), least, most);
}

std::size_t count_needed(const KldConfig& config, const ParticleSet& particles, Random& random, double share,
                         const DrawPose& anywhere) {
  std::vector<double> until(particles.size());
  std::partial_sum(particles.weight.begin(), particles.weight.end(), until.begin());
  const auto draw = [&] {
    if (share > 0.0 && random.chance(share)) return anywhere(random);
    const auto found = std::upper_bound(until.begin(), until.end() - 1, random.uniform() * until.back());
    return particles.pose(static_cast<std::size_t>(found - until.begin()));
  };
  const PoseCells space(config.cell_m, config.cell_rad);
  CellNumbers cells(static_cast<std::size_t>(config.most));
  std::size_t drawn = 0;
  auto needed = static_cast<std::size_t>(config.least);
  while (drawn < needed) {
    cells.number(space.at(draw()));
    ++drawn;
    needed = kld_count(config, cells.count());
  }
  return drawn;
}

std::vector<std::size_t> draw_by_comb(const std::vector<double>& weights, std::size_t count, Random& random) {
  std::vector<std::size_t> drawn;
  drawn.reserve(count);
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  const double step = all / static_cast<double>(count);
  const double first = random.uniform() * step;
  std::size_t i = 0;
  double until = weights[0];
  for (std::size_t tooth = 0; tooth < count; ++tooth) {
    const double at = first + static_cast<double>(tooth) * step;
    while (at >= until && i + 1 < weights.size()) until += weights[++i];
    drawn.push_back(i);
  }
  return drawn;
}

ParticleSet drawn_of(const ParticleSet& particles, const std::vector<std::size_t>& drawn) {
  ParticleSet those;
  for (std::vector<float>* const numbers : {&those.x, &those.y, &those.heading}) numbers->reserve(drawn.size());
  those.weight.reserve(drawn.size());
  for (const std::size_t i : drawn) those.add(particles.pose(i), 1.0 / static_cast<double>(drawn.size()));
  return those;
}

ParticleSet resample(const ParticleSet& particles, std::size_t count, Random& random) {
  return drawn_of(particles, draw_by_comb(particles.weight, count, random));
}

void inject(ParticleSet& particles, double share, const DrawPose& anywhere, Random& random) {
  if (share <= 0.0) return;
  for (std::size_t i = 0; i < particles.size(); ++i)
    if (random.chance(share)) particles.set(i, anywhere(random));
}

}  // namespace weft::agents
