#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

namespace weft::agents {

/// Standard deviation of a normal distribution, in median absolute deviations.
inline constexpr double kSigmaOfMad = 1.4826;

/// `values` is not empty; of an even number the upper one of the middle.
inline double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Tukey's biweight: 1 where nothing is left, 0 from 4.685 sigma on.
inline double tukey_weight(double left, double sigma) {
  constexpr double cut = 4.685;
  const double of_cut = left / (cut * sigma);
  if (std::abs(of_cut) >= 1.0) return 0.0;
  const double rest = 1.0 - of_cut * of_cut;
  return rest * rest;
}

}  // namespace weft::agents
