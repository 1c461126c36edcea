#pragma once
#include <cstdint>
#include <vector>

#include "core/network/goal.hpp"
#include "core/network/network.hpp"
#include "storage/map_store.hpp"

namespace weft::server {

/// Names a place that a robot may touch, and how far from it any part of the robot may be.
struct Touched {
  PlaceId place;
  double reach_m = 0.0;
};

/// Bounds from below how far from its nearest place a robot is reckoned to be, for paths that are not quite followed.
/// Between two places it is nearer to one of them than half their distance.
inline constexpr double kLeastSlack_m = 0.25;
/// Sets the gap that is kept between two robots besides what is uncertain.
inline constexpr double kMargin_m = 0.1;

/// Returns what lies in route.places[from .. to] for a robot of that footprint.
std::vector<Touched> touched_by(const Route& route, std::uint32_t from, std::uint32_t to, double footprint_m);
inline std::vector<Touched> touched_by(const storage::PutOccupancy& held, double footprint_m) {
  return touched_by(held.held, held.from, held.to, footprint_m);
}

/// Returns what a robot may touch that is at a place which the network does not have yet, as while it is led along a
/// new run: around the newest place of that run, else around `before`, where it stood, as far as the places since may
/// lie apart. No place: neither is known.
Touched touched_beyond(const Snapshot& network, const PlaceId& place, const PlaceId& before, double footprint_m);

}  // namespace weft::server
