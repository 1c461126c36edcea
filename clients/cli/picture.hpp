#pragma once
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/json.hpp"
#include "clients/cli/label_placement.hpp"
#include "clients/cli/layout.hpp"
#include "clients/cli/legend.hpp"
#include "clients/cli/plan_layer.hpp"
#include "clients/cli/robot_marks.hpp"
#include "clients/cli/run_list.hpp"
#include "clients/cli/run_names.hpp"
#include "core/network/window.hpp"

namespace weft::cli {

inline constexpr Colour kStitch = {0.45, 0.20, 0.55};
inline constexpr Colour kHeld = {0.98, 0.80, 0.10};
inline constexpr double kPlaceRadius = 3.2;
inline constexpr double kLabelRadius = 8.0;
inline constexpr double kRobotRadius = 16.0;
inline constexpr double kThickRun = 4.0;
inline constexpr double kThickStitch = 1.6;
inline constexpr double kThinStitch = 0.6;    // that nobody drives over
inline constexpr double kTagWords = 15.0;     // size
inline constexpr double kDetailWords = 14.0;  // size, below the title

inline constexpr std::size_t kMostRunsListed = 12;  ///< in the legend, and named on the drawing
inline constexpr std::size_t kMostLabels = 1000;    ///< named; others are marked only

/// Holds what is to be drawn.
struct Subject {
  Window network;
  Layout layout;
  std::optional<Ground> ground;
  Names robot_names;
  RunNames run_names;
  std::optional<RobotsOnMap> robots;  ///< none: robots are no part of the picture
};

/// Holds words of a picture with what they name, and where they stand.
struct Tag {
  std::string words;
  LabelWish wish;
  Colour frame = kWhite;  ///< of the box around them
  Colour ink = kInk;
  Box box = {};
};

/// Gives the tags boxes that neither cover one another nor what is marked, and makes the sheet large enough for them
/// and for the legend.
void place(std::vector<Tag>& tags, const std::vector<Box>& marks, const std::vector<Point>& points, Sheet& sheet,
           double legend_height);

/// Returns a tag for the words, as wide as they are, at an anchor that has a mark of radius `clear`.
Tag make_tag(const std::string& words, const Point& anchor, double clear, const WidthOf& width);

/// Returns a line for each of the longest runs, and for each kind of mark that there is.
Legend legend_of(const Subject& subject, const std::vector<Run>& runs);

/// Holds a picture's words and where they go, decided before anything is drawn.
struct Picture {
  Sheet sheet;
  std::string title;
  std::string detail;
  std::vector<Tag> tags;
  Legend legend;
  LegendLayout legend_layout;
};
Picture compose(const Subject& subject, const WidthOf& width);

}  // namespace weft::cli
