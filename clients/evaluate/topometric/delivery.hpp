#pragma once
#include <cstddef>
#include <optional>
#include <set>
#include <string>

#include "clients/evaluate/topometric/taught.hpp"
#include "core/network/goal.hpp"

namespace weft::evaluate::topometric {

/// Tells how a robot came to a goal. Samples are counted from the ride's first.
struct Delivery {
  PlaceId goal;
  bool has_arrived = false;
  std::string ended;  ///< why it stands, when it has not arrived
  std::size_t from_sample = 0;
  std::size_t to_sample = 0;                       ///< the last of it
  double route_m = 0.0;                            ///< as the map has it, when it set out
  std::size_t plans = 0;                           ///< routes that it was given
  std::size_t blocked = 0;                         ///< times that it said that something stood in its way
  std::optional<std::size_t> blocked_sample = {};  ///< at which it said so first
};

/// Bounds a drive.
struct DeliveryLimits {
  double most_s = 900.0;
  double most_m_after_blocked = 1e9;  ///< by odometry; then it ends, as "driven far enough"
};

/// Lets a robot that stands find out where it is. `told`: at which place it was switched on; none: it has to find
/// out. None: stopped; false: it did not, within so many seconds.
Result<std::optional<bool>> find_itself(Ride& ride, const Rider& rider, const Taught& taught,
                                        const std::optional<PlaceId>& told, double within_s);

/// Drives to a place as the server would send it there: over the shortest route, and over another one when something
/// has stood in its way for half a minute (that hop is closed for the rest of this goal), or when it was lost and has
/// found itself. None: stopped.
Result<std::optional<Delivery>> deliver(Ride& ride, const Rider& rider, const Taught& taught, const PlaceId& goal,
                                        const DeliveryLimits& limits);

/// Returns the shortest route that uses none of those edges. Errors of shortest_path.
Result<Route> route_without(const Taught& taught, const PlaceId& from, const PlaceId& to,
                            const std::set<EdgeId>& closed);

/// Returns how long a route is, by its relations.
double metres_of(const Route& route);

}  // namespace weft::evaluate::topometric
