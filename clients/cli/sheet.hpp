#pragma once
#include <vector>

#include "core/geometry/pose2.hpp"
#include "drawing/ink.hpp"

namespace weft::cli {

using drawing::Colour;
using drawing::kInk;
using drawing::kQuiet;
using drawing::kWhite;
using drawing::Point;

/// Describes a rectangle of the sheet.
struct Box {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;
};
inline Box around(const Point& at, double radius) {
  return {at.x - radius, at.y - radius, at.x + radius, at.y + radius};
}

inline constexpr double kSheetMargin = 60.0;

/// Describes the sheet of a drawing: maps the drawing's metres to the sheet's units, y turned round. The title is
/// above, the network below it, the legend last.
struct Sheet {
  double scale = 1.0;       ///< units a metre
  double left = 0.0;        ///< the drawing's x at the margin
  double top = 0.0;         ///< the drawing's y below the title
  double width = 0.0;       ///< of all
  double height = 0.0;      ///< of all
  double legend_top = 0.0;  ///< the legend's first line
  Point operator()(const Pose2& pose) const;
  /// Returns where the network and its labels may be.
  Box room() const;
  /// Makes the sheet larger, so that `taken` is in its room, and gives the legend a height.
  void grow(const Box& taken, double legend_height);
};

/// Returns a sheet on which all the poses have room; the legend has no height yet.
Sheet fit(const std::vector<Pose2>& poses);

/// Returns the longest round number of metres that takes at most `most` units of the sheet; at least a millimetre.
double round_metres(double scale, double most);

}  // namespace weft::cli
