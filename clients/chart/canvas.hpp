#pragma once
#include <cairo.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/result.hpp"

/// The canvas that charts and the pictures of studies are drawn on. Lengths in pixels, y downwards.
namespace weft::charts {

struct Colour {
  double r, g, b;
};
/// Told apart by people who see colours differently (Okabe & Ito).
inline constexpr Colour kInk = {0.13, 0.15, 0.18};
inline constexpr Colour kQuiet = {0.50, 0.53, 0.57};
inline constexpr Colour kGrid = {0.88, 0.89, 0.91};
inline constexpr Colour kBlue = {0.00, 0.45, 0.70};
inline constexpr Colour kVermilion = {0.84, 0.37, 0.00};
inline constexpr Colour kGreen = {0.00, 0.62, 0.45};
inline constexpr Colour kOrange = {0.90, 0.62, 0.00};
inline constexpr Colour kPurple = {0.80, 0.47, 0.65};
inline constexpr Colour kSky = {0.34, 0.71, 0.91};
inline constexpr Colour kWhite = {1.0, 1.0, 1.0};

struct Dot {
  double x = 0.0;
  double y = 0.0;
};

/// invalid: it ends neither in .png nor in .svg.
Result<void> check_picture_name(const std::string& file);

class Canvas {
 public:
  /// White. What becomes of a file that ends in .svg, or of a PNG.
  Canvas(std::filesystem::path file, double wide, double tall);

  void text(double x, double y, const std::string& words, double size, const Colour& ink);
  /// Turned anticlockwise by a right angle, centred on y.
  void upright_text(double x, double y, const std::string& words, double size, const Colour& ink);
  double width(const std::string& words, double size);
  void line(const Dot& from, const Dot& to, const Colour& ink, double thick, bool dashed = false);
  /// Not finite: a gap.
  void curve(const std::vector<Dot>& dots, const Colour& ink, double thick, bool dashed = false);
  void mark(const Dot& at, double radius, const Colour& ink, bool full);
  /// Nothing outside of it is drawn until `free`.
  void keep_within(double left, double top, double wide, double tall);
  void free();

  /// At the end; nothing is drawn afterwards. unavailable: names the file.
  Result<void> write();

 private:
  void colour(const Colour& ink);

  std::filesystem::path file_;
  std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface_;
  std::unique_ptr<cairo_t, decltype(&cairo_destroy)> pen_;
};

}  // namespace weft::charts
