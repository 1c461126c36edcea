#include "clients/evaluate/disturbances/summary.hpp"

#include <cmath>
#include <limits>

#include "clients/evaluate/table.hpp"

namespace weft::evaluate {
Spread spread_of(const Rows& rows, const std::string& variant, Seeds seeds, double Score::*value) {
  constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
  Spread spread{0.0, kNothing, kNothing};
  int count = 0;
  for (auto at = rows.lower_bound({variant, seeds.first});
       at != rows.end() && at->first.first == variant && at->first.second <= seeds.last; ++at) {
    const double here = at->second.*value;
    if (!std::isfinite(here)) continue;
    spread.mean += here;
    spread.least = std::fmin(spread.least, here);
    spread.most = std::fmax(spread.most, here);
    ++count;
  }
  spread.mean = count == 0 ? kNothing : spread.mean / count;
  return spread;
}

std::string table_of(const Rows& rows, const std::vector<std::string>& variants, Seeds seeds) {
  std::vector<std::vector<std::string>> cells = {{"disturbances"}};
  for (const Column& column : columns()) cells.front().emplace_back(column.heading);
  for (const std::string& variant : variants) {
    cells.push_back({variant});
    for (const Column& column : columns()) {
      cells.back().push_back(cell(spread_of(rows, variant, seeds, column.value).mean, column.digits));
    }
  }
  return markdown_table(cells, 1);
}

}  // namespace weft::evaluate
