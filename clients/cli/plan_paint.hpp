#pragma once
#include <cairo.h>

#include "core/result.hpp"
#include "storage/formats/floor_plan.hpp"

namespace weft::cli {

/// Paints the cells. `sheet_from_plan` takes the plan's metres to the pen's units.
/// invalid: more cells in a row or column than cairo draws, 32767.
Result<void> paint(cairo_t* pen, const formats::FloorPlan& plan, const cairo_matrix_t& sheet_from_plan);

}  // namespace weft::cli
