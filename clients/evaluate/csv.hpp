#pragma once
#include <sstream>
#include <string>
#include <vector>

namespace weft::evaluate {

/// Writes rows of CSV cell by cell. Numbers look as streams print them, words stand in quotes.
class CsvText {
 public:
  /// Begins with these names of columns.
  explicit CsvText(const std::vector<std::string>& columns);

  CsvText& words(const std::string& cell);
  /// Leaves the cell empty where the value is not finite.
  CsvText& number(double cell);
  template <class Value>
  CsvText& value(const Value& cell) {
    begin_cell();
    text_ << cell;
    return *this;
  }
  CsvText& empty(int cells = 1);
  void end_row();

  std::string text() const { return text_.str(); }

 private:
  void begin_cell();

  std::ostringstream text_;
  bool is_first_ = true;
};

/// Splits a row at its commas; cells in quotes are not read.
std::vector<std::string> csv_cells(const std::string& row);

}  // namespace weft::evaluate
