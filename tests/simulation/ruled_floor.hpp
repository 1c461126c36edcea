#pragma once
#include <functional>
#include <optional>

#include "core/geometry/pose2.hpp"
#include "core/network/goal.hpp"
#include "core/network/rule.hpp"

namespace weft::simulation {

/// Returns where a place truly lies; none: nobody knows.
using Truth = std::function<std::optional<Pose2>(const PlaceId&)>;

/// Returns the first place of the route, from `first` through what is released, that lies in what the rule closes,
/// with the way there from outside beginning at the place before `first`; none: it leads in nowhere. Judged by the
/// floor alone: what lies at the edge of it counts as neither.
std::optional<PlaceId> enters_closed(const Rule& rule, const Route& route, std::uint32_t first, const Truth& truth);

/// Returns the first place of the route, from `first` through what is released, that lies in what the rule slows and
/// for which the route states no limit as low; none: there is none. Judged as above.
std::optional<PlaceId> lacks_limit(const Rule& rule, const Route& route, std::uint32_t first, const Truth& truth);

}  // namespace weft::simulation
