#pragma once
#include <cstddef>
#include <optional>

#include "clients/evaluate/topometric/scenes.hpp"
#include "clients/evaluate/topometric/score.hpp"
#include "clients/evaluate/topometric/taught.hpp"

namespace weft::evaluate::topometric {

/// Lifts r1 and puts it down so many times within 0.2 m of where it was taught, every second time headed the other
/// way, and lets it look for itself for 40 s each. Values: put_downs, found, found_percent, wrong (it believes to be
/// elsewhere), found_median_s. None: stopped.
Result<std::optional<Measured>> measure_kidnapped(const agents::sim::Site& site,
                                                  const std::vector<agents::SitePoint>& line, const Driven& driven,
                                                  const Taught& taught, std::size_t put_downs);

}  // namespace weft::evaluate::topometric
