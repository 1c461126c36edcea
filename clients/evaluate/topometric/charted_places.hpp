#pragma once
#include "clients/evaluate/taught_map.hpp"
#include "clients/evaluate/topometric/grid_errors.hpp"
#include "clients/evaluate/topometric/taught.hpp"
#include "core/result.hpp"

namespace weft::evaluate::topometric {

/// Makes the chart around a place as a robot with that map does. corrupt: a content that the method cannot read.
Result<agents::Topometric::Chart> chart_around(const TaughtMap& map, const agents::Topometric& method,
                                               const PlaceId& centre);

/// Judges the grids of charts around every so many of these places.
Result<GridErrors> grid_errors_of(const TaughtMap& map, const agents::Topometric& method,
                                  const std::vector<PlaceId>& places, std::size_t every, const TruePlaces& truth,
                                  const TrueHall& hall);

}  // namespace weft::evaluate::topometric
