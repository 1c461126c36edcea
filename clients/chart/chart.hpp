#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "clients/chart/canvas.hpp"
#include "core/result.hpp"

namespace weft::charts {

/// A curve in the chart's units, y upwards.
struct Curve {
  enum class Look { line, dashed, dots, steps };
  std::string name;  ///< in the legend; empty: not there
  std::vector<Dot> dots;
  Colour ink = kBlue;
  Look look = Look::line;
  double thick = 1.4;
};

struct Chart {
  std::string title;
  std::string x_label;  ///< with its unit
  std::string y_label;
  std::vector<Curve> curves;   ///< the first is drawn first
  bool is_map = false;         ///< one scale for both axes
  std::optional<Dot> y_range;  ///< from x to y; without one what the curves have
  bool y_from_zero = false;
};

/// The size of each chart, pixels.
struct ChartSize {
  double wide = 560.0;
  double tall = 330.0;
};

/// A PNG, or a file that ends in .svg: charts beside and below each other, `columns` in a row, each with axes, units
/// and a legend.
Result<void> draw_charts(const std::string& title, const std::string& about, const std::vector<Chart>& charts,
                         std::size_t columns, const std::filesystem::path& file, const ChartSize& size = {});

/// Grid lines of an axis from `low` to `high`: a step of 1, 2 or 5 times a power of ten, about `many` of them.
double grid_step(double low, double high, int many);

}  // namespace weft::charts
