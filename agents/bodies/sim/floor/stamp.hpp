#pragma once
#include <span>

namespace weft::agents::sim {

/// Holds a square picture of floats over a part of the floor, to draw on.
struct Canvas {
  std::span<float> values;  ///< row-major, `side` x `side`
  int side = 0;
  double texel_m = 0.0;
  double x0_m = 0.0, y0_m = 0.0;  ///< lower corner in the site frame
};

/// Adds `grey` within the ellipse, fading over `soft_m` at its rim.
struct Ellipse {
  double x = 0.0, y = 0.0;
  double a_m = 0.0, b_m = 0.0;  ///< half axes
  double angle = 0.0;
  double soft_m = 0.0;
  double grey = 0.0;
};
void stamp(const Ellipse& ellipse, const Canvas& canvas);

/// Adds `grey` likewise along a stroke.
struct Stroke {
  double x0 = 0.0, y0 = 0.0, x1 = 0.0, y1 = 0.0;
  double half_width_m = 0.0;
  double soft_m = 0.0;
  double grey = 0.0;
};
void stamp(const Stroke& stroke, const Canvas& canvas);

/// Adds `grey` likewise along a bend around (x, y), fading over `fade_m` towards both ends.
struct Arc {
  double x = 0.0, y = 0.0, radius_m = 1.0;
  double middle = 0.0, half_angle = 0.0;  ///< at most 1.4; of the way from its middle to an end
  double half_width_m = 0.0;
  double soft_m = 0.0, fade_m = 0.1;
  double grey = 0.0;
};
void stamp(const Arc& arc, const Canvas& canvas);

}  // namespace weft::agents::sim
