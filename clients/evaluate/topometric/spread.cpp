#include "clients/evaluate/topometric/spread.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace weft::evaluate::topometric {
namespace {
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
}  // namespace

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return kNone;
  const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size())));
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::clamp<std::size_t>(rank, 1, values.size()) - 1);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double mean_of(const std::vector<double>& values) {
  if (values.empty()) return kNone;
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double largest_of(const std::vector<double>& values) {
  return values.empty() ? kNone : *std::max_element(values.begin(), values.end());
}

double percent_of(double part, double whole) {
  return whole > 0.0 ? 100.0 * part / whole : kNone;
}

}  // namespace weft::evaluate::topometric
