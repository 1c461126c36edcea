#include "clients/cli/paint_legend.hpp"

#include "clients/cli/paint_robots.hpp"
#include "clients/cli/paint_sheet.hpp"

namespace weft::cli {
namespace {

using Sample = LegendLine::Sample;

constexpr double kSampleEnd = 44.0;

/// Draws a small one of what the line explains, from `at` to the right.
void paint_sample(drawing::Canvas& canvas, const LegendLine& line, const Point& at) {
  const Point middle{at.x + 0.5 * kSampleEnd, at.y};
  const Point end{at.x + kSampleEnd, at.y};
  switch (line.sample) {
    case Sample::none:
      break;
    case Sample::run:
      canvas.stroke(at, end, line.ink, {line.thick});
      for (const double part : {0.0, 0.5, 1.0}) canvas.dot({at.x + part * kSampleEnd, at.y}, kPlaceRadius, line.ink);
      break;
    case Sample::line:
      canvas.stroke(at, end, line.ink, {line.thick, line.dashed});
      break;
    case Sample::dot:
      canvas.dot(middle, line.thick, line.ink);
      break;
    case Sample::label:
      paint_ring(canvas, middle, line.ink);
      break;
    case Sample::robot:
      paint_robot(canvas, middle, 0.0, RobotMark::Look::heard);
      break;
    case Sample::robot_lost:
      paint_robot(canvas, middle, 0.0, RobotMark::Look::lost);
      break;
    case Sample::robot_silent:
      paint_robot(canvas, middle, 0.0, RobotMark::Look::silent);
      break;
    case Sample::held:
      paint_held(canvas, {at, end}, 14.0, true);
      break;
    case Sample::ahead:
      paint_ahead(canvas, {at, end});
      break;
    case Sample::goal:
      paint_goal(canvas, middle);
      break;
  }
}

}  // namespace

void paint_legend(drawing::Canvas& canvas, const Legend& legend, const LegendLayout& layout, double top) {
  std::size_t at = 0;
  for (const std::vector<LegendLine>* const lines : {&legend.runs, &legend.marks}) {
    for (const LegendLine& line : *lines) {
      const Point from{kSheetMargin + layout.lines[at].x, top + layout.lines[at].y};
      ++at;
      paint_sample(canvas, line, from);
      const bool is_bare = line.sample == LegendLine::Sample::none;
      canvas.text({from.x + kLegendSample, from.y + 5.0}, line.words, kLegendWords, is_bare ? line.ink : kInk);
    }
  }
}

}  // namespace weft::cli
