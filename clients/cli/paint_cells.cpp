#include "clients/cli/paint_cells.hpp"

#include <memory>

namespace weft::cli {

Result<void> paint(cairo_t* pen, const Cells& cells, const cairo_matrix_t& pen_from_cells) {
  constexpr std::size_t kMost = 32'767;
  if (cells.columns > kMost || cells.rows > kMost) {
    return fail(ErrorCode::invalid, cells.name + " has " + std::to_string(cells.columns) + " x " +
                                        std::to_string(cells.rows) + " cells; at most 32767 a side are drawn");
  }
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create(CAIRO_FORMAT_ARGB32, static_cast<int>(cells.columns), static_cast<int>(cells.rows)),
      cairo_surface_destroy);
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS) {
    return fail(ErrorCode::exhausted, "no memory for " + cells.name);
  }
  cairo_surface_flush(surface.get());
  std::uint8_t* const bytes = cairo_image_surface_get_data(surface.get());
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  for (std::size_t row = 0; row < cells.rows; ++row) {
    auto* const pixels = reinterpret_cast<std::uint32_t*>(bytes + row * stride);
    for (std::size_t column = 0; column < cells.columns; ++column) pixels[column] = cells.argb(row, column);
  }
  cairo_surface_mark_dirty(surface.get());
  cairo_save(pen);
  cairo_transform(pen, &pen_from_cells);
  cairo_set_source_surface(pen, surface.get(), 0.0, 0.0);
  cairo_paint(pen);
  cairo_restore(pen);
  return {};
}

}  // namespace weft::cli
