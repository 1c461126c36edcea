#pragma once
#include <functional>
#include <string>

namespace weft::cli {

/// Returns the width of words at a size, in units of the sheet.
using WidthOf = std::function<double(const std::string& words, double size)>;

/// Returns how wide words are on every canvas.
WidthOf text_widths();

}  // namespace weft::cli
