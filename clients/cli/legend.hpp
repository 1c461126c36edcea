#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "clients/cli/sheet.hpp"
#include "clients/cli/text_width.hpp"

namespace weft::cli {

/// Describes a line of the legend: a sample of a mark, and what it means.
struct LegendLine {
  enum class Sample { none, line, run, dot, label, robot, robot_lost, robot_silent, held, ahead, goal };
  Sample sample = Sample::none;
  std::string words;
  Colour ink = kInk;
  double thick = 0.0;
  bool dashed = false;
};

/// Holds the legend: runs on the left, marks on the right.
struct Legend {
  std::vector<LegendLine> runs;
  std::vector<LegendLine> marks;
};

inline constexpr double kLegendLine = 26.0;    // from one line to the next
inline constexpr double kLegendWords = 15.0;   // size
inline constexpr double kLegendSample = 60.0;  // before the words

/// Returns "1 run", "3 runs", "2 stitches".
std::string how_many(std::size_t count, const std::string& thing);

/// Returns the words, cut short with an ellipsis between two characters where they are wider than `most`.
std::string elided(const std::string& words, double size, double most, const WidthOf& width);

/// Says where each line begins, from the legend's upper left corner, runs first: in two columns if all words have
/// room in them, else one below the other.
struct LegendLayout {
  std::vector<Point> lines;
  double height = 0.0;
};
LegendLayout lay_legend(const Legend& legend, double wide, const WidthOf& width);

}  // namespace weft::cli
