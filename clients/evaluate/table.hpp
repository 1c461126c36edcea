#pragma once
#include <string>
#include <vector>

namespace weft::evaluate {

/// Returns the value with so many digits after the point; "-" for what is not finite.
std::string cell(double value, int digits);

/// Returns Markdown with aligned columns: the first row is the heading, the first `words` columns are words, the
/// others numbers.
std::string markdown_table(const std::vector<std::vector<std::string>>& rows, std::size_t words);

}  // namespace weft::evaluate
