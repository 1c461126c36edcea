#include "clients/chart/canvas.hpp"

#include <cairo-svg.h>

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace weft::charts {

namespace {

/// Straight into what the file becomes: a recording that is played into an SVG is never freed (cairo 1.16).
cairo_surface_t* sheet_for(const std::filesystem::path& file, double wide, double tall) {
  if (file.extension() == ".svg") return cairo_svg_surface_create(file.c_str(), wide, tall);
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(wide), static_cast<int>(tall));
}

}  // namespace

Result<void> check_picture_name(const std::string& file) {
  if (file.ends_with(".png") || file.ends_with(".svg")) return {};
  return fail(ErrorCode::invalid, file + ": give a name that ends in .png or .svg");
}

Canvas::Canvas(std::filesystem::path file, double wide, double tall)
    : file_(std::move(file)),
      surface_(sheet_for(file_, wide, tall), cairo_surface_destroy),
      pen_(cairo_create(surface_.get()), cairo_destroy) {
  colour(kWhite);
  cairo_paint(pen_.get());
  cairo_select_font_face(pen_.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
}

void Canvas::colour(const Colour& ink) {
  cairo_set_source_rgb(pen_.get(), ink.r, ink.g, ink.b);
}

void Canvas::text(double x, double y, const std::string& words, double size, const Colour& ink) {
  colour(ink);
  cairo_set_font_size(pen_.get(), size);
  cairo_move_to(pen_.get(), x, y);
  cairo_show_text(pen_.get(), words.c_str());
  cairo_new_path(pen_.get());  // it has left a point behind
}

void Canvas::upright_text(double x, double y, const std::string& words, double size, const Colour& ink) {
  cairo_save(pen_.get());
  cairo_translate(pen_.get(), x, y + 0.5 * width(words, size));
  cairo_rotate(pen_.get(), -0.5 * std::numbers::pi);
  text(0.0, 0.0, words, size, ink);
  cairo_restore(pen_.get());
}

double Canvas::width(const std::string& words, double size) {
  cairo_text_extents_t extents{};
  cairo_set_font_size(pen_.get(), size);
  cairo_text_extents(pen_.get(), words.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::line(const Dot& from, const Dot& to, const Colour& ink, double thick, bool dashed) {
  curve({from, to}, ink, thick, dashed);
}

void Canvas::curve(const std::vector<Dot>& dots, const Colour& ink, double thick, bool dashed) {
  const std::array<double, 2> dashes = {4.0, 4.0};
  colour(ink);
  cairo_set_dash(pen_.get(), dashes.data(), dashed ? 2 : 0, 0.0);
  cairo_set_line_width(pen_.get(), thick);
  bool is_down = false;
  for (const Dot& dot : dots) {
    const bool is_there = std::isfinite(dot.x) && std::isfinite(dot.y);
    if (is_there) is_down ? cairo_line_to(pen_.get(), dot.x, dot.y) : cairo_move_to(pen_.get(), dot.x, dot.y);
    is_down = is_there;
  }
  cairo_stroke(pen_.get());
  cairo_set_dash(pen_.get(), nullptr, 0, 0.0);
}

void Canvas::mark(const Dot& at, double radius, const Colour& ink, bool full) {
  cairo_arc(pen_.get(), at.x, at.y, radius, 0.0, 2.0 * std::numbers::pi);
  colour(full ? ink : kWhite);
  cairo_fill_preserve(pen_.get());
  colour(ink);
  cairo_set_line_width(pen_.get(), 1.6);
  cairo_stroke(pen_.get());
}

void Canvas::keep_within(double left, double top, double wide, double tall) {
  cairo_save(pen_.get());
  cairo_rectangle(pen_.get(), left, top, wide, tall);
  cairo_clip(pen_.get());
}

void Canvas::free() {
  cairo_restore(pen_.get());
}

Result<void> Canvas::write() {
  pen_.reset();
  const bool svg = file_.extension() == ".svg";
  if (svg) cairo_surface_finish(surface_.get());
  const cairo_status_t status =
      svg ? cairo_surface_status(surface_.get()) : cairo_surface_write_to_png(surface_.get(), file_.c_str());
  if (status == CAIRO_STATUS_SUCCESS) return {};
  return fail(ErrorCode::unavailable,
              file_.string() + ": " + cairo_status_to_string(status) + "; is the folder there?");
}

}  // namespace weft::charts
