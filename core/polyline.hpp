#pragma once
#include <string_view>
#include <vector>

#include "core/result.hpp"

namespace weft {

/// Describes a point of a line that a robot is to drive along; metres in the site's frame.
struct PolylinePoint {
  double x = 0.0;
  double y = 0.0;
};

/// Reads one point "x y" or "x,y" a line; '#' begins a comment, a line without a point is skipped.
/// invalid: names file, line and the bound of what is wrong: coordinates lie within +-100000 m.
Result<std::vector<PolylinePoint>> parse_polyline_points(std::string_view text, std::string_view file);

}  // namespace weft
