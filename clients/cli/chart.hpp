#pragma once
#include <string>
#include <vector>

#include "core/result.hpp"
#include "drawing/canvas.hpp"

namespace weft::cli {

/// Describes a curve in the chart's units, y upwards.
struct Curve {
  std::string name;                    ///< in the legend
  std::vector<drawing::Point> points;  ///< one that is not finite leaves a gap
  drawing::Colour ink = drawing::kInk;
  drawing::Line line = {};
};

struct Range {
  double low = 0.0;
  double high = 1.0;
};

struct Chart {
  std::string title;    ///< of the picture
  std::string about;    ///< below it
  std::string x_label;  ///< with its unit
  std::string y_label;
  Range x;
  Range y;
  std::vector<Curve> curves;  ///< the first is drawn first
};

/// Draws a PNG, or an SVG of a file that ends in .svg, with axes, units and a legend. invalid: another ending;
/// exhausted: the file cannot be written.
Result<void> draw_chart(const Chart& chart, const std::string& file, double wide, double tall);

/// Returns the distance of grid lines of which there are at most about `many`: 1, 2 or 5 times a power of ten.
double grid_step(double low, double high, int many);

}  // namespace weft::cli
