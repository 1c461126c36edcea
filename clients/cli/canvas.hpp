#pragma once
#include <cairo.h>

#include <memory>
#include <string>
#include <vector>

#include "clients/cli/legend.hpp"
#include "clients/cli/picture.hpp"
#include "clients/cli/sheet.hpp"
#include "core/result.hpp"

namespace weft::cli {

/// Sets the letters that pictures are written in; none is moved to whole pixels, so that widths are the same for
/// every kind of file.
void choose_letters(cairo_t* pen);

/// A file to draw on, with what every drawing of a network has: title, scale, tags, legend.
class Canvas {
 public:
  /// invalid: the file's name ends neither in .png nor in .svg.
  static Result<Canvas> make(const std::string& file, const Sheet& sheet);
  /// exhausted: the file cannot be written.
  Result<void> finish();

  const Sheet& sheet() const { return sheet_; }
  cairo_t* pen() const { return pen_.get(); }

  /// Title and detail on the left, and a bar of a round number of metres on the right.
  void head(const std::string& title, const std::string& detail);
  /// Words where they were placed, with lines to what they name.
  void tags(const std::vector<Tag>& tags);

  void stroke(const Point& a, const Point& b, const Colour& ink, double thick, bool dashed);
  void dot(const Point& at, double radius, const Colour& ink);
  /// The mark of a labelled place.
  void ring(const Point& at, const Colour& ink);
  void text(const Point& at, const std::string& words, double size, const Colour& ink);

 private:
  struct Free {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* pen) const { cairo_destroy(pen); }
  };
  Canvas(std::string file, const Sheet& sheet);
  void colour(const Colour& ink) { cairo_set_source_rgb(pen_.get(), ink.r, ink.g, ink.b); }
  void scale_bar();

  std::string file_;
  Sheet sheet_;
  std::unique_ptr<cairo_surface_t, Free> surface_;
  std::unique_ptr<cairo_t, Free> pen_;
};

}  // namespace weft::cli
