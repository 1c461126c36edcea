#pragma once
#include <cstdint>
#include <optional>

#include "agents/navigation/route_ahead.hpp"

namespace weft::agents {

/// Returns how fast a route's speed limits let the robot drive now, m/s; none: no limit matters. The lowest counts of
/// those that hold where it is, and of those ahead: it has slowed down when its footprint comes there, braking with
/// `brake_m_s2`. `at`: the last place passed.
std::optional<double> route_limit(const Route& route, const RouteAround& around, std::uint32_t at,
                                  double footprint_radius_m, double brake_m_s2);

}  // namespace weft::agents
