#include "agents/bodies/sim/wave.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace weft::agents::sim {
namespace {

TEST(Wave, HasItsRmsAndStaysInItsBand) {
  const Wave wave(5.0, 20.0, 0.5, Random(3));
  constexpr int kSamples = 2000;
  constexpr double kStepS = 0.0125;
  std::vector<double> values;
  double squares = 0.0;
  for (int i = 0; i < kSamples; ++i) {
    values.push_back(wave.at(i * kStepS));
    squares += values.back() * values.back();
  }
  EXPECT_NEAR(std::sqrt(squares / kSamples), 0.5, 0.03);
  const auto power = [&](double hz) {
    std::complex<double> sum = 0.0;
    for (int i = 0; i < kSamples; ++i) {
      sum += values[static_cast<std::size_t>(i)] * std::polar(1.0, -2.0 * M_PI * hz * i * kStepS);
    }
    return std::norm(sum) / kSamples / kSamples;
  };
  double inside = 0.0;
  double outside = 0.0;
  for (double hz = 0.04; hz < 40.0; hz += 0.04) {
    (hz > 4.9 && hz < 20.1 ? inside : outside) += power(hz);
  }
  EXPECT_GT(inside, 30.0 * outside);
}

TEST(BoundedWave, NeverPassesItsPeak) {
  const BoundedWave wave(0.1, 0.5, 0.04, Random(3));
  double most = 0.0;
  for (double t = 0.0; t < 1000.0; t += 0.05) {
    most = std::max(most, std::abs(wave.at(t)));
  }
  EXPECT_LE(most, 0.04);
  EXPECT_GT(most, 0.03);
}

}  // namespace
}  // namespace weft::agents::sim
