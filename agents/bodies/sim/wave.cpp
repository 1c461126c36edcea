#include "agents/bodies/sim/wave.hpp"

#include <cmath>
#include <numbers>

namespace weft::agents::sim {
namespace {

constexpr int kSines = 12;

}  // namespace

Wave::Wave(double low, double high, double rms, Random random) : amplitude_(rms * std::sqrt(2.0 / kSines)) {
  // One sine in each twelfth of the band: no seed leaves a part of it empty.
  for (int i = 0; i < kSines; ++i) {
    const double frequency = low + (high - low) * (i + random.uniform()) / kSines;
    sines_.push_back({2.0 * std::numbers::pi * frequency, random.uniform(0.0, 2.0 * std::numbers::pi)});
  }
}

double Wave::at(double argument) const {
  double sum = 0.0;
  for (const Sine& sine : sines_) {
    sum += std::sin(sine.rate * argument + sine.phase);
  }
  return amplitude_ * sum;
}

BoundedWave::BoundedWave(double low, double high, double peak, Random random)
    : peak_(peak), wave_(low, high, 1.0, random) {}

double BoundedWave::at(double argument) const {
  return peak_ * std::tanh(wave_.at(argument));
}

}  // namespace weft::agents::sim
