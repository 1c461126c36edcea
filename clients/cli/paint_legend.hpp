#pragma once
#include "clients/cli/legend.hpp"
#include "drawing/canvas.hpp"

namespace weft::cli {

/// Draws the legend's lines, each with a sample of what it explains, from `top` on.
void paint_legend(drawing::Canvas& canvas, const Legend& legend, const LegendLayout& layout, double top);

}  // namespace weft::cli
