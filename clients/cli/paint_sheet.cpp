#include "clients/cli/paint_sheet.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace weft::cli {
namespace {

void paint_scale_bar(drawing::Canvas& canvas, const Sheet& sheet) {
  const double metres = round_metres(sheet.scale, 240.0);
  const double y = 36.0;
  const double right = sheet.width - kSheetMargin;
  const double left = right - metres * sheet.scale;
  canvas.stroke({left, y}, {right, y}, kInk, {2.0});
  canvas.stroke({left, y - 6.0}, {left, y + 6.0}, kInk, {2.0});
  canvas.stroke({right, y - 6.0}, {right, y + 6.0}, kInk, {2.0});
  std::array<char, 32> words{};
  std::snprintf(words.data(), words.size(), metres == 1.0 ? "%g metre" : "%g metres", metres);
  const double half = 0.5 * text_widths()(words.data(), kLegendWords);
  const double middle = std::min(0.5 * (left + right), right - half);
  canvas.text({middle - half, y - 10.0}, words.data(), kLegendWords, kInk);
}

}  // namespace

void paint_head(drawing::Canvas& canvas, const Sheet& sheet, const std::string& title, const std::string& detail) {
  canvas.text({kSheetMargin, 42.0}, title, 24.0, kInk);
  canvas.text({kSheetMargin, 66.0}, detail, kDetailWords, kQuiet);
  paint_scale_bar(canvas, sheet);
}

void paint_tags(drawing::Canvas& canvas, const std::vector<Tag>& tags) {
  for (const Tag& tag : tags) {
    if (needs_leader(tag.wish, tag.box))
      canvas.stroke(tag.wish.anchor, nearest_in(tag.box, tag.wish.anchor), kQuiet, {1.0});
  }
  for (const Tag& tag : tags) {
    const Box& box = tag.box;
    cairo_t* const pen = canvas.pen();
    cairo_rectangle(pen, box.left + 1.0, box.top + 1.0, tag.wish.wide - 2.0, tag.wish.tall - 2.0);
    cairo_set_source_rgba(pen, 1.0, 1.0, 1.0, 0.9);
    cairo_fill_preserve(pen);
    cairo_set_source_rgb(pen, tag.frame.r, tag.frame.g, tag.frame.b);
    cairo_set_line_width(pen, 1.2);
    cairo_stroke(pen);
    canvas.text({box.left + 4.0, box.top + 18.0}, tag.words, kTagWords, tag.ink);
  }
}

void paint_ring(drawing::Canvas& canvas, const Point& at, const Colour& ink) {
  canvas.dot(at, kLabelRadius, ink);
  canvas.dot(at, 5.0, kWhite);
}

}  // namespace weft::cli
