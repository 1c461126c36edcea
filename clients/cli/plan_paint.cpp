#include "clients/cli/plan_paint.hpp"

#include <cmath>
#include <memory>
#include <string>

namespace weft::cli {
namespace {

/// Returns white for floor, dark for walls, grey for the unknown: all pale enough for the network upon them.
std::uint32_t colour_of(std::int8_t cell) {
  constexpr std::uint32_t kUnknown = 0xe6;
  constexpr double kFree = 255.0;
  constexpr double kWall = 110.0;
  const std::uint32_t grey =
      cell < 0 ? kUnknown : static_cast<std::uint32_t>(std::lround(kFree + (kWall - kFree) * cell / 100.0));
  return (grey << 16U) | (grey << 8U) | grey;
}

}  // namespace

Result<void> paint(cairo_t* pen, const formats::FloorPlan& plan, const cairo_matrix_t& sheet_from_plan) {
  constexpr std::uint32_t kMost = 32'767;
  if (plan.width > kMost || plan.height > kMost) {
    return fail(ErrorCode::invalid, "the floor plan has " + std::to_string(plan.width) + " x " +
                                        std::to_string(plan.height) + " cells; at most 32767 a side are drawn");
  }
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> cells(
      cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(plan.width), static_cast<int>(plan.height)),
      cairo_surface_destroy);
  if (cairo_surface_status(cells.get()) != CAIRO_STATUS_SUCCESS) {
    return fail(ErrorCode::exhausted, "no memory for the floor plan");
  }
  cairo_surface_flush(cells.get());
  std::uint8_t* const bytes = cairo_image_surface_get_data(cells.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(cells.get()));
  for (std::size_t row = 0; row < plan.height; ++row) {
    auto* const pixels = reinterpret_cast<std::uint32_t*>(bytes + row * stride);
    for (std::size_t column = 0; column < plan.width; ++column) {
      pixels[column] = colour_of(plan.cells[row * plan.width + column]);
    }
  }
  cairo_surface_mark_dirty(cells.get());
  cairo_save(pen);
  cairo_transform(pen, &sheet_from_plan);
  cairo_translate(pen, plan.plan_from_grid.x, plan.plan_from_grid.y);
  cairo_rotate(pen, plan.plan_from_grid.heading);
  cairo_scale(pen, plan.cell_m, plan.cell_m);
  cairo_set_source_surface(pen, cells.get(), 0.0, 0.0);
  cairo_paint(pen);
  cairo_restore(pen);
  return {};
}

}  // namespace weft::cli
