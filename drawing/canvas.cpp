#include "drawing/canvas.hpp"

#include <cairo-svg.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace weft::drawing {

void choose_letters(cairo_t* pen) {
  cairo_select_font_face(pen, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
  cairo_font_options_t* const options = cairo_font_options_create();
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_set_font_options(pen, options);
  cairo_font_options_destroy(options);
}

Result<void> check_picture_name(const std::string& file) {
  if (file.ends_with(".png") || file.ends_with(".svg")) return {};
  return fail(ErrorCode::invalid, file + ": give a name that ends in .png or .svg");
}

// Straight into what the file becomes: a recording that is played into an SVG is never freed (cairo 1.16).
Canvas::Canvas(std::string file, double wide, double tall) : file_(std::move(file)) {
  surface_.reset(file_.ends_with(".svg") ? cairo_svg_surface_create(file_.c_str(), wide, tall)
                                         : cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(wide),
                                                                      static_cast<int>(tall)));
  pen_.reset(cairo_create(surface_.get()));
  colour(kWhite);
  cairo_paint(pen());
  choose_letters(pen());
  cairo_set_line_cap(pen(), CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(pen(), CAIRO_LINE_JOIN_ROUND);
}

Result<Canvas> Canvas::make(const std::string& file, double wide, double tall) {
  if (const Result<void> named = check_picture_name(file); !named) return fail(named.error());
  return Canvas(file, wide, tall);
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

void Canvas::curve(const std::vector<Point>& points, const Colour& ink, const Line& line) {
  const std::array<double, 2> dashes = {7.0, 7.0};
  colour(ink);
  cairo_set_dash(pen(), dashes.data(), line.dashed ? 2 : 0, 0.0);
  cairo_set_line_width(pen(), line.thick);
  bool is_down = false;
  for (const Point& point : points) {
    const bool is_there = std::isfinite(point.x) && std::isfinite(point.y);
    if (is_there) is_down ? cairo_line_to(pen(), point.x, point.y) : cairo_move_to(pen(), point.x, point.y);
    is_down = is_there;
  }
  cairo_stroke(pen());
  cairo_set_dash(pen(), nullptr, 0, 0.0);
}

void Canvas::stroke(const Point& from, const Point& to, const Colour& ink, const Line& line) {
  curve({from, to}, ink, line);
}

void Canvas::dot(const Point& at, double radius, const Colour& ink) {
  colour(ink);
  cairo_arc(pen(), at.x, at.y, radius, 0.0, 2.0 * std::numbers::pi);
  cairo_fill(pen());
}

void Canvas::box(const Point& corner, double wide, double tall, const Colour& ink, bool is_filled) {
  colour(ink);
  cairo_set_line_width(pen(), 1.0);
  cairo_rectangle(pen(), corner.x, corner.y, wide, tall);
  is_filled ? cairo_fill(pen()) : cairo_stroke(pen());
}

void Canvas::text(const Point& at, const std::string& words, double size, const Colour& ink) {
  colour(ink);
  cairo_set_font_size(pen(), size);
  cairo_move_to(pen(), at.x, at.y);
  cairo_show_text(pen(), words.c_str());
  cairo_new_path(pen());  // it has left a point behind
}

void Canvas::upright_text(const Point& middle, const std::string& words, double size, const Colour& ink) {
  cairo_save(pen());
  cairo_translate(pen(), middle.x, middle.y + 0.5 * width_of(words, size));
  cairo_rotate(pen(), -0.5 * std::numbers::pi);
  text({0.0, 0.0}, words, size, ink);
  cairo_restore(pen());
}

double Canvas::width_of(const std::string& words, double size) {
  cairo_text_extents_t extents{};
  cairo_set_font_size(pen(), size);
  cairo_text_extents(pen(), words.c_str(), &extents);
  return extents.x_advance;
}

}  // namespace weft::drawing
