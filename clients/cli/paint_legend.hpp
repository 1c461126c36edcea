#pragma once
#include "clients/cli/canvas.hpp"
#include "clients/cli/legend.hpp"

namespace weft::cli {

/// Draws the legend's lines, each with a sample of what it explains, from the sheet's `legend_top` on.
void paint_legend(Canvas& canvas, const Legend& legend, const LegendLayout& layout);

}  // namespace weft::cli
