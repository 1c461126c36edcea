#include "clients/evaluate/disturbances/summary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace weft::evaluate {
namespace {

std::string cell(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

/// The first column is words, the others are numbers.
std::string line(const std::vector<std::string>& cells, const std::vector<std::size_t>& widths) {
  std::string text = "|";
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::string space(widths[i] - cells[i].size(), ' ');
    text += " " + (i == 0 ? cells[i] + space : space + cells[i]) + " |";
  }
  return text + "\n";
}

}  // namespace

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
  std::vector<std::size_t> widths(cells.front().size(), 0);
  for (const auto& row : cells) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text = line(cells.front(), widths) + "|";
  for (std::size_t i = 0; i < widths.size(); ++i) text += std::string(widths[i] + 1, '-') + (i == 0 ? "-|" : ":|");
  text += "\n";
  for (std::size_t i = 1; i < cells.size(); ++i) text += line(cells[i], widths);
  return text;
}

}  // namespace weft::evaluate
