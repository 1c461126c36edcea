#include "clients/cli/draw_mosaic.hpp"

#include <vector>

#include "clients/cli/paint_cells.hpp"
#include "clients/cli/paint_sheet.hpp"
#include "clients/cli/picture.hpp"

namespace weft::cli {
namespace {

/// Returns the mosaic as cells: its greys, and nothing where no patch shows anything.
Cells cells_of(const Mosaic& mosaic) {
  constexpr std::uint32_t kOpaqueGrey = 0xff000000U;
  const auto argb = [&](std::size_t row, std::size_t column) -> std::uint32_t {
    const std::uint32_t grey = mosaic.greys[row * mosaic.columns + column];
    return grey == 0 ? 0U : kOpaqueGrey | (grey << 16U) | (grey << 8U) | grey;
  };
  return {"the mosaic", mosaic.columns, mosaic.rows, argb};
}

/// Returns the places with labels that lie below the mosaic, where they are on the sheet; at most kMostLabels.
std::vector<std::pair<std::string, Point>> labels_below(const Mosaic& mosaic, const Window& network,
                                                        const Layout& layout, const Sheet& sheet) {
  std::vector<std::pair<std::string, Point>> labels;
  for (const auto& [label, place] : network.labels) {
    const auto pose = layout.drawing_from_place.find(place);
    if (pose == layout.drawing_from_place.end() || !mosaic.covers(pose->second.translation())) continue;
    if (labels.size() < kMostLabels) labels.emplace_back(label, sheet(pose->second));
  }
  return labels;
}

}  // namespace

Result<void> draw_mosaic(const Mosaic& mosaic, const Window& network, const Layout& layout, const std::string& title,
                         const std::string& detail, const std::string& file) {
  const auto [low, high] = mosaic.extent();
  Sheet sheet = fit({low, high});
  const WidthOf width = text_widths();
  std::vector<Tag> tags;
  std::vector<Box> marks;
  for (const auto& [label, at] : labels_below(mosaic, network, layout, sheet)) {
    tags.push_back(make_tag(label, at, kLabelRadius, width));
    marks.push_back(around(at, kLabelRadius));
  }
  place(tags, marks, {}, sheet, 0.0);
  Result<drawing::Canvas> canvas = drawing::Canvas::make(file, sheet.width, sheet.height);
  if (!canvas) return fail(canvas.error());
  const Point corner = sheet({mosaic.corner_in_drawing.x(), mosaic.corner_in_drawing.y(), 0.0});
  const double cell = mosaic.metres_per_pixel * sheet.scale;
  cairo_matrix_t sheet_from_cells{};
  cairo_matrix_init(&sheet_from_cells, cell, 0.0, 0.0, cell, corner.x, corner.y);
  if (const Result<void> painted = paint(canvas->pen(), cells_of(mosaic), sheet_from_cells); !painted) return painted;
  paint_head(*canvas, sheet, title + ", revision " + std::to_string(network.revision.value), detail);
  for (const Tag& tag : tags) paint_ring(*canvas, tag.wish.anchor, kInk);
  paint_tags(*canvas, tags);
  return canvas->finish();
}

}  // namespace weft::cli
