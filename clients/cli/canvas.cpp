#include "clients/cli/canvas.hpp"

#include <cairo-svg.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>
#include <utility>

#include "clients/chart/canvas.hpp"

namespace weft::cli {

void choose_letters(cairo_t* pen) {
  cairo_select_font_face(pen, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_font_options_t* const options = cairo_font_options_create();
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_set_font_options(pen, options);
  cairo_font_options_destroy(options);
}

Canvas::Canvas(std::string file, const Sheet& sheet) : file_(std::move(file)), sheet_(sheet) {
  surface_.reset(file_.ends_with(".svg")
                     ? cairo_svg_surface_create(file_.c_str(), sheet.width, sheet.height)
                     : cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(sheet.width),
                                                  static_cast<int>(sheet.height)));
  pen_.reset(cairo_create(surface_.get()));
  colour(kWhite);
  cairo_paint(pen());
  choose_letters(pen());
  cairo_set_line_cap(pen(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(pen(), CAIRO_LINE_JOIN_ROUND);
}

Result<Canvas> Canvas::make(const std::string& file, const Sheet& sheet) {
  if (const Result<void> named = charts::check_picture_name(file); !named) return fail(named.error());
  return Canvas(file, sheet);
}

Result<void> Canvas::finish() {
  const bool svg = file_.ends_with(".svg");
  cairo_surface_flush(surface_.get());
  if (svg) cairo_surface_finish(surface_.get());
  const cairo_status_t status =
      svg ? cairo_surface_status(surface_.get()) : cairo_surface_write_to_png(surface_.get(), file_.c_str());
  if (status == CAIRO_STATUS_SUCCESS) return {};
  return fail(ErrorCode::exhausted, file_ + ": " + cairo_status_to_string(status) + "; is the folder there?");
}

void Canvas::head(const std::string& title, const std::string& detail) {
  text({kSheetMargin, 42.0}, title, 24.0, kInk);
  text({kSheetMargin, 66.0}, detail, kDetailWords, kQuiet);
  scale_bar();
}

void Canvas::scale_bar() {
  const double metres = round_metres(sheet_.scale, 240.0);
  const double y = 36.0;
  const double right = sheet_.width - kSheetMargin;
  const double left = right - metres * sheet_.scale;
  stroke({left, y}, {right, y}, kInk, 2.0, false);
  stroke({left, y - 6.0}, {left, y + 6.0}, kInk, 2.0, false);
  stroke({right, y - 6.0}, {right, y + 6.0}, kInk, 2.0, false);
  std::array<char, 32> words{};
  std::snprintf(words.data(), words.size(), metres == 1.0 ? "%g metre" : "%g metres", metres);
  const double half = 0.5 * text_widths()(words.data(), kLegendWords);
  const double middle = std::min(0.5 * (left + right), right - half);
  text({middle - half, y - 10.0}, words.data(), kLegendWords, kInk);
}

void Canvas::tags(const std::vector<Tag>& tags) {
  for (const Tag& tag : tags) {
    if (needs_leader(tag.wish, tag.box))
      stroke(tag.wish.anchor, nearest_in(tag.box, tag.wish.anchor), kQuiet, 1.0, false);
  }
  for (const Tag& tag : tags) {
    const Box& box = tag.box;
    cairo_rectangle(pen(), box.left + 1.0, box.top + 1.0, tag.wish.wide - 2.0, tag.wish.tall - 2.0);
    cairo_set_source_rgba(pen(), 1.0, 1.0, 1.0, 0.9);
    cairo_fill_preserve(pen());
    colour(tag.frame);
    cairo_set_line_width(pen(), 1.2);
    cairo_stroke(pen());
    text({box.left + 4.0, box.top + 18.0}, tag.words, kTagWords, tag.ink);
  }
}

void Canvas::stroke(const Point& a, const Point& b, const Colour& ink, double thick, bool dashed) {
  const std::array<double, 2> dashes = {7.0, 7.0};
  colour(ink);
  cairo_set_dash(pen(), dashes.data(), dashed ? 2 : 0, 0.0);
  cairo_set_line_width(pen(), thick);
  cairo_move_to(pen(), a.x, a.y);
  cairo_line_to(pen(), b.x, b.y);
  cairo_stroke(pen());
  cairo_set_dash(pen(), nullptr, 0, 0.0);
}

void Canvas::dot(const Point& at, double radius, const Colour& ink) {
  colour(ink);
  cairo_arc(pen(), at.x, at.y, radius, 0.0, 2.0 * std::numbers::pi);
  cairo_fill(pen());
}

void Canvas::ring(const Point& at, const Colour& ink) {
  dot(at, kLabelRadius, ink);
  dot(at, 5.0, kWhite);
}

void Canvas::text(const Point& at, const std::string& words, double size, const Colour& ink) {
  colour(ink);
  cairo_set_font_size(pen(), size);
  cairo_move_to(pen(), at.x, at.y);
  cairo_show_text(pen(), words.c_str());
  cairo_new_path(pen());  // it has left a point behind
}

}  // namespace weft::cli
