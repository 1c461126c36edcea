#include "clients/evaluate/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace weft::evaluate {

std::string cell(double value, int digits) {
  if (!std::isfinite(value)) return "-";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

std::string markdown_table(const std::vector<std::vector<std::string>>& rows, std::size_t words) {
  std::vector<std::size_t> widths(rows.front().size(), 0);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  for (const auto& row : rows) {
    text += "|";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(widths[i] - row[i].size(), ' ');
      text += " " + (i < words ? row[i] + space : space + row[i]) + " |";
    }
    text += "\n";
    if (&row != &rows.front()) continue;
    text += "|";
    for (std::size_t i = 0; i < widths.size(); ++i)
      text += std::string(widths[i] + 1, '-') + (i < words ? "-|" : ":|");
    text += "\n";
  }
  return text;
}

}  // namespace weft::evaluate
