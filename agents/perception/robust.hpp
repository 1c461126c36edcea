#pragma once
#include <algorithm>
#include <cmath>
#include <vector>

namespace weft::agents {

/// Is the standard deviation of a normal distribution, in median absolute deviations.
inline constexpr double kSigmaOfMad = 1.4826;

/// Returns the median, of an even number of values the upper of the two in the middle. `values` is not empty.
inline double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns Tukey's biweight of a residual `left`: 1 for a residual of 0, 0 from 4.685 sigma on.
inline double tukey_weight(double left, double sigma) {
  constexpr double cut = 4.685;
  const double of_cut = left / (cut * sigma);
  if (std::abs(of_cut) >= 1.0) return 0.0;
  const double rest = 1.0 - of_cut * of_cut;
  return rest * rest;
}

}  // namespace weft::agents
