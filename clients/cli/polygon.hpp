#pragma once
#include <Eigen/Core>
#include <set>
#include <string_view>
#include <vector>

#include "clients/cli/layout.hpp"
#include "core/network/rule.hpp"
#include "core/result.hpp"

namespace weft::cli {

using Polygon = std::vector<Eigen::Vector2d>;

/// Reads "X,Y;X,Y;X,Y", metres in a floor plan's frame. invalid: the text is anything else, or encloses nothing;
/// names what is wrong.
Result<Polygon> parse_polygon(std::string_view text);

/// Returns whether the point lies within the polygon, counted by edges crossed.
bool contains(const Polygon& polygon, const Eigen::Vector2d& point);

/// Returns the places within the polygon, of those laid out in the plan's frame, and where a run crosses it between
/// two places, the two on either side of it.
std::set<PlaceId> places_within(const Layout& layout, const Polygon& polygon);

/// Returns the stretches of runs that `places_within` makes. A stretch goes on over places that have left the map.
/// not_found: there is none; invalid: they are more than one rule can name.
Result<std::vector<Span>> spans_within(const Layout& layout, const Polygon& polygon);

}  // namespace weft::cli
