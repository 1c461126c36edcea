#pragma once
#include <vector>

namespace weft::evaluate::topometric {

/// Returns the value that this share of them does not exceed (nearest rank); NaN of none.
double quantile(std::vector<double> values, double share);
double mean_of(const std::vector<double>& values);     ///< NaN of none
double largest_of(const std::vector<double>& values);  ///< NaN of none
/// Returns the share of `part` in `whole`, percent; NaN of nothing.
double percent_of(double part, double whole);

}  // namespace weft::evaluate::topometric
