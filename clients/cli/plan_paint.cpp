#include "clients/cli/plan_paint.hpp"

#include <cmath>

#include "clients/cli/paint_cells.hpp"

namespace weft::cli {
namespace {

/// Returns white for floor, dark for walls, grey for the unknown: all pale enough for the network upon them.
std::uint32_t colour_of(std::int8_t cell) {
  constexpr std::uint32_t kOpaque = 0xff000000U;
  constexpr std::uint32_t kUnknown = 0xe6;
  constexpr double kFree = 255.0;
  constexpr double kWall = 110.0;
  const std::uint32_t grey =
      cell < 0 ? kUnknown : static_cast<std::uint32_t>(std::lround(kFree + (kWall - kFree) * cell / 100.0));
  return kOpaque | (grey << 16U) | (grey << 8U) | grey;
}

}  // namespace

Result<void> paint(cairo_t* pen, const formats::FloorPlan& plan, const cairo_matrix_t& sheet_from_plan) {
  cairo_matrix_t sheet_from_cells = sheet_from_plan;
  cairo_matrix_translate(&sheet_from_cells, plan.plan_from_grid.x, plan.plan_from_grid.y);
  cairo_matrix_rotate(&sheet_from_cells, plan.plan_from_grid.heading);
  cairo_matrix_scale(&sheet_from_cells, plan.cell_m, plan.cell_m);
  const auto argb = [&](std::size_t row, std::size_t column) {
    return colour_of(plan.cells[row * plan.width + column]);
  };
  return paint(pen, Cells{"the floor plan", plan.width, plan.height, argb}, sheet_from_cells);
}

}  // namespace weft::cli
