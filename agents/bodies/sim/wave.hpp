#pragma once
#include <vector>

#include "core/random.hpp"

namespace weft::agents::sim {

/// Makes band-limited noise that can be asked for at any argument: a sum of sines with random frequencies and phases.
class Wave {
 public:
  /// Draws frequencies within [low, high] (cycles per unit of the argument); the root mean square is `rms`.
  Wave(double low, double high, double rms, Random random);
  double at(double argument) const;

 private:
  struct Sine {
    double rate = 0.0;  ///< radians per unit of the argument
    double phase = 0.0;
  };
  double amplitude_ = 0.0;
  std::vector<Sine> sines_;
};

/// Makes a wave of which |value| <= peak always holds.
class BoundedWave {
 public:
  BoundedWave(double low, double high, double peak, Random random);
  double at(double argument) const;

 private:
  double peak_ = 0.0;
  Wave wave_;
};

}  // namespace weft::agents::sim
