#pragma once
#include <string>
#include <vector>

#include "clients/evaluate/disturbances/rows.hpp"
#include "clients/evaluate/surroundings.hpp"

namespace weft::evaluate {

/// Summarises one number of a variant over the seeds; NaN where no seed had anything to measure.
struct Spread {
  double mean = 0.0;
  double least = 0.0;
  double most = 0.0;
};
/// Returns mean and spread over those seeds that are there.
Spread spread_of(const Rows& rows, const std::string& variant, Seeds seeds, double Score::*value);

/// Returns the means, a row a variant, as a Markdown table with aligned columns.
std::string table_of(const Rows& rows, const std::vector<std::string>& variants, Seeds seeds);

}  // namespace weft::evaluate
