#include "clients/cli/paint_robots.hpp"

#include <array>
#include <numbers>

#include "clients/cli/picture.hpp"

namespace weft::cli {
namespace {

constexpr Colour kGone = {0.66, 0.68, 0.71};
constexpr Colour kLostRim = {0.84, 0.20, 0.00};

void trace(drawing::Canvas& canvas, const std::vector<Point>& points) {
  cairo_new_path(canvas.pen());
  for (const Point& point : points) cairo_line_to(canvas.pen(), point.x, point.y);
}

}  // namespace

void paint_held(drawing::Canvas& canvas, const std::vector<Point>& points, double wide, bool is_whole) {
  cairo_t* const pen = canvas.pen();
  cairo_set_source_rgba(pen, kHeld.r, kHeld.g, kHeld.b, 0.5);
  if (points.size() > 1 && is_whole) {
    trace(canvas, points);
    cairo_set_line_width(pen, wide);
    cairo_stroke(pen);
    return;
  }
  for (const Point& point : points) {
    cairo_arc(pen, point.x, point.y, 0.5 * wide, 0.0, 2.0 * std::numbers::pi);
    cairo_fill(pen);
  }
}

void paint_ahead(drawing::Canvas& canvas, const std::vector<Point>& points) {
  cairo_t* const pen = canvas.pen();
  const std::array<double, 2> bars = {2.0, 6.0};
  cairo_save(pen);
  trace(canvas, points);
  cairo_set_source_rgb(pen, kInk.r, kInk.g, kInk.b);
  cairo_set_line_width(pen, 10.0);
  cairo_set_line_cap(pen, CAIRO_LINE_CAP_BUTT);
  cairo_set_dash(pen, bars.data(), 2, 0.0);
  cairo_stroke(pen);
  cairo_restore(pen);
}

void paint_goal(drawing::Canvas& canvas, const Point& at) {
  canvas.dot(at, 14.0, kInk);
  canvas.dot(at, 11.5, kHeld);
}

void paint_robot(drawing::Canvas& canvas, const Point& at, double heading, RobotMark::Look look) {
  cairo_t* const pen = canvas.pen();
  cairo_save(pen);
  cairo_translate(pen, at.x, at.y);
  cairo_rotate(pen, -heading);
  cairo_move_to(pen, kRobotRadius, 0.0);
  cairo_line_to(pen, -10.0, 10.0);
  cairo_line_to(pen, -5.0, 0.0);
  cairo_line_to(pen, -10.0, -10.0);
  cairo_close_path(pen);
  const Colour& fill = look == RobotMark::Look::heard ? kHeld : look == RobotMark::Look::lost ? kWhite : kGone;
  const Colour& rim = look == RobotMark::Look::lost ? kLostRim : kInk;
  const std::array<double, 2> dashes = {3.0, 3.5};
  cairo_set_source_rgb(pen, fill.r, fill.g, fill.b);
  cairo_fill_preserve(pen);
  cairo_set_source_rgb(pen, rim.r, rim.g, rim.b);
  cairo_set_line_width(pen, look == RobotMark::Look::lost ? 2.6 : 1.6);
  cairo_set_dash(pen, dashes.data(), look == RobotMark::Look::silent ? 2 : 0, 0.0);
  cairo_stroke(pen);
  cairo_restore(pen);
}

}  // namespace weft::cli
