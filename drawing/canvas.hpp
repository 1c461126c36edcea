#pragma once
#include <cairo.h>

#include <memory>
#include <string>
#include <vector>

#include "core/result.hpp"
#include "drawing/ink.hpp"

/// Draws all pictures of the product; studies have their measurements drawn elsewhere (clients/evaluate/charts).
namespace weft::drawing {

/// Sets the letters that pictures are written in; none is moved to whole pixels, so that widths are the same for
/// every kind of file.
void choose_letters(cairo_t* pen);

/// Checks that a picture can be written under this name. invalid: it ends neither in .png nor in .svg.
Result<void> check_picture_name(const std::string& file);

struct Line {
  double thick = 1.0;
  bool dashed = false;
};

/// Holds a white sheet to draw on; it becomes a PNG or, of a file that ends in .svg, an SVG.
class Canvas {
 public:
  /// Makes a sheet of that size, in pixels. invalid: as check_picture_name().
  static Result<Canvas> make(const std::string& file, double wide, double tall);
  /// Writes the file; nothing is drawn afterwards. exhausted: it cannot be written.
  Result<void> finish();

  /// Draws from point to point; one that is not finite leaves a gap.
  void curve(const std::vector<Point>& points, const Colour& ink, const Line& line);
  void stroke(const Point& from, const Point& to, const Colour& ink, const Line& line);
  void dot(const Point& at, double radius, const Colour& ink);
  void box(const Point& corner, double wide, double tall, const Colour& ink, bool is_filled);
  /// Writes words to the right of a point on their base line.
  void text(const Point& at, const std::string& words, double size, const Colour& ink);
  /// Writes words turned anticlockwise by a right angle, their middle at the point.
  void upright_text(const Point& middle, const std::string& words, double size, const Colour& ink);
  double width_of(const std::string& words, double size);

  /// Returns Cairo's own pen, for what only one picture draws.
  cairo_t* pen() const { return pen_.get(); }

 private:
  struct Free {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* pen) const { cairo_destroy(pen); }
  };
  Canvas(std::string file, double wide, double tall);
  void colour(const Colour& ink) { cairo_set_source_rgb(pen_.get(), ink.r, ink.g, ink.b); }

  std::string file_;
  std::unique_ptr<cairo_surface_t, Free> surface_;
  std::unique_ptr<cairo_t, Free> pen_;
};

}  // namespace weft::drawing
