#pragma once
#include <string>
#include <vector>

#include "clients/cli/picture.hpp"
#include "clients/cli/sheet.hpp"
#include "drawing/canvas.hpp"

namespace weft::cli {

/// Writes title and detail on the left, and on the right a bar of a round number of metres.
void paint_head(drawing::Canvas& canvas, const Sheet& sheet, const std::string& title, const std::string& detail);

/// Writes words where they were placed, with lines to what they name.
void paint_tags(drawing::Canvas& canvas, const std::vector<Tag>& tags);

/// Draws the mark of a labelled place.
void paint_ring(drawing::Canvas& canvas, const Point& at, const Colour& ink);

}  // namespace weft::cli
