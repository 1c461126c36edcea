#include "clients/cli/sheet.hpp"

#include <algorithm>

namespace weft::cli {
namespace {

constexpr double kSheetWidth = 1600.0;
constexpr double kAboveNetwork = 110.0;
constexpr double kBelowNetwork = 40.0;
constexpr double kTallestNetwork = 1400.0;
constexpr double kEdgeOfSheet = 8.0;  // nothing comes nearer to it
constexpr double kHeadroom = 80.0;    // of the title alone
constexpr double kAboveLegend = 36.0;

}  // namespace

Point Sheet::operator()(const Pose2& pose) const {
  return {kSheetMargin + (pose.x - left) * scale, kAboveNetwork + (top - pose.y) * scale};
}

Box Sheet::room() const {
  return {kEdgeOfSheet, kHeadroom, width - kEdgeOfSheet, legend_top - kAboveLegend};
}

void Sheet::grow(const Box& taken, double legend_height) {
  width = std::max(width, taken.right + kEdgeOfSheet);
  legend_top = std::max(legend_top, taken.bottom + kAboveLegend);
  height = legend_top + legend_height + kBelowNetwork;
}

Sheet fit(const std::vector<Pose2>& poses) {
  double left = 0.0;
  double right = 1.0;
  double bottom = 0.0;
  double top = 1.0;
  bool first = true;
  for (const Pose2& pose : poses) {
    left = first ? pose.x : std::min(left, pose.x);
    right = first ? pose.x : std::max(right, pose.x);
    bottom = first ? pose.y : std::min(bottom, pose.y);
    top = first ? pose.y : std::max(top, pose.y);
    first = false;
  }
  const double wide = std::max(right - left, 1.0);
  const double tall = std::max(top - bottom, 1.0);
  constexpr double for_network = kSheetWidth - 2.0 * kSheetMargin;
  Sheet sheet;
  sheet.scale = std::min(for_network / wide, kTallestNetwork / tall);
  sheet.left = left - 0.5 * (for_network / sheet.scale - wide);
  sheet.top = top;
  sheet.width = kSheetWidth;
  sheet.legend_top = kAboveNetwork + tall * sheet.scale + kBelowNetwork + kAboveLegend;
  sheet.height = sheet.legend_top + kBelowNetwork;
  return sheet;
}

double round_metres(double scale, double most) {
  double metres = 0.001;
  for (double decade = 0.001; decade < 1e6; decade *= 10.0) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      if (factor * decade * scale <= most) metres = factor * decade;
    }
  }
  return metres;
}

}  // namespace weft::cli
