#pragma once
#include <cairo.h>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "core/result.hpp"

namespace weft::cli {

struct Colour {
  double r = 0.0, g = 0.0, b = 0.0;
};
inline constexpr Colour kInk = {0.13, 0.15, 0.18};
inline constexpr Colour kQuiet = {0.50, 0.53, 0.57};
inline constexpr Colour kWhite = {1.0, 1.0, 1.0};

/// Units of the sheet.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

/// From the drawing's metres to the sheet's units; y turned round.
struct Sheet {
  double scale = 1.0;
  double left = 0.0;
  double top = 0.0;
  double height = 0.0;
  double legend_top = 0.0;  ///< the legend's first line
  Point operator()(const Pose2& pose) const;
};

/// A sheet on which all of them have room, with `legend_lines` below.
Sheet fit(const std::vector<Pose2>& poses, std::size_t legend_lines);

/// A file to draw on, with what every drawing of a network has: title, scale, legend.
class Canvas {
 public:
  /// invalid: the file's name ends neither in .png nor in .svg.
  static Result<Canvas> make(const std::string& file, const Sheet& sheet);
  /// exhausted: the file cannot be written.
  Result<void> finish();

  const Sheet& sheet() const { return sheet_; }
  cairo_t* pen() const { return pen_.get(); }

  void title(const std::string& title, const std::string& detail);
  /// A bar of a round number of metres, above to the right.
  void scale_bar();
  /// One more line of the legend; lines are counted from the first.
  void legend_line(const std::string& words, const Colour& ink, double thick, bool dashed = false);

  void stroke(const Point& a, const Point& b, const Colour& ink, double thick, bool dashed);
  void dot(const Point& at, double radius, const Colour& ink);
  /// Words beside a point, on a white ground so that lines do not run through them.
  void tag(const Point& at, const std::string& words, double size, const Colour& ink);
  /// A dot with its words.
  void label(const Point& at, const std::string& words, const Colour& ink);
  void text(const Point& at, const std::string& words, double size, const Colour& ink);
  double width(const std::string& words, double size);

 private:
  struct Free {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* pen) const { cairo_destroy(pen); }
  };
  Canvas(std::string file, const Sheet& sheet);
  void colour(const Colour& ink) { cairo_set_source_rgb(pen_.get(), ink.r, ink.g, ink.b); }

  std::string file_;
  Sheet sheet_;
  double legend_y_ = 0.0;
  std::unique_ptr<cairo_surface_t, Free> surface_;
  std::unique_ptr<cairo_t, Free> pen_;
};

}  // namespace weft::cli
