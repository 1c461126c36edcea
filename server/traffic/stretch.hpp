#pragma once
#include <cstdint>
#include <vector>

#include "core/network/goal.hpp"
#include "server/traffic/nearness.hpp"
#include "storage/map_store.hpp"

namespace weft::server {

/// A place that a robot may touch, and how far from it any part of the robot may be.
struct Touched {
  PlaceId place;
  double reach_m = 0.0;
};

/// Between two places a robot is nearer to one of them than half their distance; no less than this is reckoned
/// with, for paths that are not quite followed.
inline constexpr double kLeastSlack_m = 0.25;
/// Kept free between two robots besides what is uncertain.
inline constexpr double kMargin_m = 0.1;

/// What lies in route.places[from .. to] for a robot of that footprint.
std::vector<Touched> touched_by(const Route& route, std::uint32_t from, std::uint32_t to, double footprint_m);
inline std::vector<Touched> touched_by(const storage::PutOccupancy& held, double footprint_m) {
  return touched_by(held.held, held.from, held.to, footprint_m);
}

/// The same with what lies around the place; as short-lived as `Nearness::around`.
struct Looked {
  Touched touched;
  const std::vector<Near>* around = nullptr;
};
Looked look(const Ground& ground, Nearness& nearness, const Touched& touched);
std::vector<Looked> look(const Ground& ground, Nearness& nearness, const std::vector<Touched>& touched);

/// Whether two robots could touch: a place of one lies within both reaches and the margin of a place of the other,
/// seen from either side. Two runs over one floor that nothing stitches together know nothing of each other.
bool overlap(const Looked& a, const Looked& b);
bool overlap(const Ground& ground, Nearness& nearness, const std::vector<Touched>& a, const std::vector<Touched>& b);

}  // namespace weft::server
