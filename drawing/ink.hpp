#pragma once

namespace weft::drawing {

struct Colour {
  double r = 0.0, g = 0.0, b = 0.0;
  bool operator==(const Colour&) const = default;
};
/// Is one of the inks that people who see colours differently can tell apart (Okabe & Ito).
inline constexpr Colour kInk = {0.13, 0.15, 0.18};
inline constexpr Colour kQuiet = {0.50, 0.53, 0.57};
inline constexpr Colour kGrid = {0.88, 0.89, 0.91};
inline constexpr Colour kVermilion = {0.84, 0.37, 0.00};
inline constexpr Colour kSky = {0.34, 0.71, 0.91};
inline constexpr Colour kWhite = {1.0, 1.0, 1.0};

/// Is in units of the sheet, y downwards.
struct Point {
  double x = 0.0;
  double y = 0.0;
};

}  // namespace weft::drawing
