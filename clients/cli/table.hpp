#pragma once
#include <algorithm>
#include <ostream>
#include <string>
#include <vector>

namespace weft::cli {

/// Prints columns as wide as what stands in them. The first row is the heading.
class Table {
 public:
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  /// Puts a cell into the last row, before that column.
  void into_last(std::size_t column, std::string cell) {
    rows_.back().insert(rows_.back().begin() + static_cast<std::ptrdiff_t>(column), std::move(cell));
  }
  void print(std::ostream& out) const {
    std::vector<std::size_t> widths;
    for (const std::vector<std::string>& row : rows_) {
      widths.resize(std::max(widths.size(), row.size()));
      for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    for (const std::vector<std::string>& row : rows_) {
      std::string line;
      for (std::size_t i = 0; i < row.size(); ++i) {
        line += row[i];
        if (i + 1 < row.size()) line += std::string(widths[i] - row[i].size() + 2, ' ');
      }
      line.erase(line.find_last_not_of(' ') + 1);
      out << line << '\n';
    }
  }

 private:
  std::vector<std::vector<std::string>> rows_;
};

/// Formats a number with so many digits after the point.
std::string fixed(double value, int digits);
inline constexpr double bytes_a_mib = 1024.0 * 1024.0;

}  // namespace weft::cli
