#include "clients/evaluate/csv.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

namespace weft::evaluate {

CsvText::CsvText(const std::vector<std::string>& columns) {
  for (const std::string& column : columns) value(column);
  end_row();
}

CsvText& CsvText::words(const std::string& cell) {
  begin_cell();
  text_ << '"' << cell << '"';
  return *this;
}

CsvText& CsvText::number(double cell) {
  return std::isfinite(cell) ? value(cell) : empty();
}

CsvText& CsvText::empty(int cells) {
  for (int i = 0; i < cells; ++i) begin_cell();
  return *this;
}

void CsvText::end_row() {
  text_ << '\n';
  is_first_ = true;
}

void CsvText::begin_cell() {
  if (!std::exchange(is_first_, false)) text_ << ',';
}

std::vector<std::string> csv_cells(const std::string& row) {
  std::vector<std::string> cells;
  std::size_t from = 0;
  for (std::size_t comma = row.find(','); comma != std::string::npos; comma = row.find(',', from)) {
    cells.push_back(row.substr(from, comma - from));
    from = comma + 1;
  }
  cells.push_back(row.substr(from));
  return cells;
}

}  // namespace weft::evaluate
