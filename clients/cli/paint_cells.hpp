#pragma once
#include <cairo.h>

#include <cstdint>
#include <functional>
#include <string>

#include "core/result.hpp"

namespace weft::cli {

/// Holds a picture of cells, row by row: of its cell's row and column, `argb` gives the colour with its opacity,
/// premultiplied as Cairo has it.
struct Cells {
  std::string name;  ///< "the floor plan", in errors
  std::size_t columns = 0, rows = 0;
  std::function<std::uint32_t(std::size_t row, std::size_t column)> argb;
};

/// Paints cells. `pen_from_cells` takes columns and rows to the pen's units.
/// invalid: more cells in a row or column than Cairo draws, 32767; exhausted: no memory.
Result<void> paint(cairo_t* pen, const Cells& cells, const cairo_matrix_t& pen_from_cells);

}  // namespace weft::cli
