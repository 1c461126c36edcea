#include "agents/methods/ceiling/gauge.hpp"

#include <cmath>
#include <vector>

namespace weft::agents {
namespace {

constexpr double kMostFactor = 1.4;     // beyond, it is not this ceiling
constexpr double kStep = 0.01;          // of the factor's logarithm
constexpr double kCornersOfOne = 10.0;  // so many corners are mostly one thing's, and tell where it hangs once

/// Returns how likely a height is, per metre, `off` above the ceiling, when it is told with that variance: a mixture
/// of the ceiling, of what hangs below it (the half of a normal density) and of what was followed wrongly.
double likelihood(const HeightPrior& prior, double off, double variance) {
  constexpr double wrong = 0.05;       // share of heights that are told wrongly, and...
  constexpr double wrong_per_m = 0.1;  // ...how densely they lie, anywhere
  const double flat_variance = variance + prior.flat_sigma_m * prior.flat_sigma_m;
  const double flat = std::exp(-0.5 * off * off / flat_variance) / std::sqrt(flat_variance);
  // Above the ceiling, only noise puts what hangs.
  const double hangs_variance = off > 0.0 ? variance : prior.hangs_sigma_m * prior.hangs_sigma_m + variance;
  const double hangs =
      2.0 * std::exp(-0.5 * off * off / hangs_variance) / std::hypot(prior.hangs_sigma_m, std::sqrt(variance));
  constexpr double normal = 0.3989;  // 1 / sqrt(2 pi)
  return (1.0 - wrong) * 0.5 * normal * (flat + hangs) + wrong * wrong_per_m;
}

double log_likelihood(std::span<const ToldHeight> heights, const HeightPrior& prior, double camera_m,
                      const KnownScale& known, double log_factor) {
  const double factor = std::exp(log_factor);
  const double off_known = (log_factor - std::log(known.factor)) / known.sigma_share;
  double sum = 0.0;
  for (const ToldHeight& told : heights) {
    const double height = camera_m + factor * (told.above_floor_m - camera_m);
    sum += std::log(likelihood(prior, height - prior.ceiling_m, factor * factor / told.information));
  }
  return sum / kCornersOfOne - 0.5 * off_known * off_known;
}

}  // namespace

double gauge_factor(std::span<const ToldHeight> heights, const HeightPrior& prior, double camera_m,
                    const KnownScale& known) {
  constexpr std::size_t fewest = 8;
  constexpr double clearly = 3.0;  // by so much the logarithm of the likelihood is to exceed that of what is held
  std::vector<ToldHeight> told;
  for (const ToldHeight& height : heights)
    if (height.information > 0.0) told.push_back(height);
  if (told.size() < fewest) return 1.0;
  const double held = log_likelihood(told, prior, camera_m, known, 0.0);
  const int steps = static_cast<int>(std::log(kMostFactor) / kStep);
  double best = 0.0;
  double most = held;
  for (int i = -steps; i <= steps; ++i) {
    const double at = log_likelihood(told, prior, camera_m, known, i * kStep);
    if (at <= most) continue;
    most = at;
    best = i * kStep;
  }
  if (known.is_held && most < held + clearly) return 1.0;
  return std::exp(best);
}

}  // namespace weft::agents
