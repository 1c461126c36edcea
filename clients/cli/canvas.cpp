#include "clients/cli/canvas.hpp"

#include <cairo-svg.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <numbers>
#include <utility>

#include "clients/chart/canvas.hpp"

namespace weft::cli {
namespace {

constexpr double kWidth = 1600.0;
constexpr double kMargin = 60.0;
constexpr double kTitle = 90.0;   // above the network
constexpr double kFooter = 70.0;  // below it, besides the legend's lines
constexpr double kLine = 26.0;    // of the legend
constexpr double kTallest = 1400.0;
constexpr double kWords = 15.0;  // size

}  // namespace

Point Sheet::operator()(const Pose2& pose) const {
  return {kMargin + (pose.x - left) * scale, kTitle + (top - pose.y) * scale};
}

Sheet fit(const std::vector<Pose2>& poses, std::size_t legend_lines) {
  double left = 0.0;
  double right = 1.0;
  double bottom = 0.0;
  double top = 1.0;
  bool first = true;
  for (const Pose2& pose : poses) {
    left = first ? pose.x : std::min(left, pose.x);
    right = first ? pose.x : std::max(right, pose.x);
    bottom = first ? pose.y : std::min(bottom, pose.y);
    top = first ? pose.y : std::max(top, pose.y);
    first = false;
  }
  const double wide = std::max(right - left, 1.0);
  const double tall = std::max(top - bottom, 1.0);
  Sheet sheet;
  sheet.scale = std::min((kWidth - 2.0 * kMargin) / wide, kTallest / tall);
  sheet.left = left - 0.5 * ((kWidth - 2.0 * kMargin) / sheet.scale - wide);
  sheet.top = top;
  sheet.legend_top = kTitle + tall * sheet.scale + kFooter + kLine;
  sheet.height = sheet.legend_top + kLine * (static_cast<double>(legend_lines) - 1.0) + kMargin;
  return sheet;
}

Canvas::Canvas(std::string file, const Sheet& sheet)
    : file_(std::move(file)), sheet_(sheet), legend_y_(sheet.legend_top) {
  surface_.reset(file_.ends_with(".svg") ? cairo_svg_surface_create(file_.c_str(), kWidth, sheet.height)
                                         : cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(kWidth),
                                                                      static_cast<int>(sheet.height)));
  pen_.reset(cairo_create(surface_.get()));
  colour(kWhite);
  cairo_paint(pen());
  cairo_select_font_face(pen(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
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

void Canvas::title(const std::string& title, const std::string& detail) {
  text({kMargin, 46.0}, title, 24.0, kInk);
  text({kMargin, 70.0}, detail, 14.0, kQuiet);
}

void Canvas::scale_bar() {
  double metres = 1.0;
  for (const double step : {2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0}) {
    if (metres * sheet_.scale < 120.0) metres = step;
  }
  const double y = 62.0;
  const double right = kWidth - kMargin;
  const double left = right - metres * sheet_.scale;
  stroke({left, y}, {right, y}, kInk, 2.0, false);
  stroke({left, y - 6.0}, {left, y + 6.0}, kInk, 2.0, false);
  stroke({right, y - 6.0}, {right, y + 6.0}, kInk, 2.0, false);
  std::array<char, 32> words{};
  std::snprintf(words.data(), words.size(), "%g m", metres);
  text({0.5 * (left + right) - 0.5 * width(words.data(), kWords), y - 10.0}, words.data(), kWords, kInk);
}

void Canvas::legend_line(const std::string& words, const Colour& ink, double thick, bool dashed) {
  stroke({kMargin, legend_y_}, {kMargin + 44.0, legend_y_}, ink, thick, dashed);
  text({kMargin + 60.0, legend_y_ + 5.0}, words, kWords, kInk);
  legend_y_ += kLine;
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

void Canvas::tag(const Point& at, const std::string& words, double size, const Colour& ink) {
  const double wide = width(words, size);
  const bool fits = at.x + 14.0 + wide < kWidth - 8.0;
  const Point from{fits ? at.x + 12.0 : at.x - 12.0 - wide, at.y - 10.0};
  cairo_set_source_rgba(pen(), 1.0, 1.0, 1.0, 0.85);
  cairo_rectangle(pen(), from.x - 3.0, from.y - size, wide + 6.0, size + 5.0);
  cairo_fill(pen());
  text(from, words, size, ink);
}

void Canvas::label(const Point& at, const std::string& words, const Colour& ink) {
  dot(at, 8.0, ink);
  dot(at, 5.0, kWhite);
  tag(at, words, kWords, ink);
}

void Canvas::text(const Point& at, const std::string& words, double size, const Colour& ink) {
  colour(ink);
  cairo_set_font_size(pen(), size);
  cairo_move_to(pen(), at.x, at.y);
  cairo_show_text(pen(), words.c_str());
}

double Canvas::width(const std::string& words, double size) {
  cairo_text_extents_t extents{};
  cairo_set_font_size(pen(), size);
  cairo_text_extents(pen(), words.c_str(), &extents);
  return extents.x_advance;
}

}  // namespace weft::cli
