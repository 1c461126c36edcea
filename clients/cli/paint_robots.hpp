#pragma once
#include <vector>

#include "clients/cli/robot_marks.hpp"
#include "clients/cli/sheet.hpp"
#include "drawing/canvas.hpp"

namespace weft::cli {

/// Draws a pale band along the points that a robot holds; a spot at each where the way between them is not known.
void paint_held(drawing::Canvas& canvas, const std::vector<Point>& points, double wide, bool is_whole);
/// Draws the rest of a route, with short bars across it.
void paint_ahead(drawing::Canvas& canvas, const std::vector<Point>& points);
void paint_goal(drawing::Canvas& canvas, const Point& at);
/// Draws a robot as an arrow that points ahead.
void paint_robot(drawing::Canvas& canvas, const Point& at, double heading, RobotMark::Look look);

}  // namespace weft::cli
