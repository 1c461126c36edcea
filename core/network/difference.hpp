#pragma once
#include "core/network/relation.hpp"

namespace weft {

/// Holds the distance and angle by which two relations between the same frames differ, or by which one may be off.
struct Difference {
  double metres = 0.0;
  double radians = 0.0;
};

/// Returns how far `b` is from `a`: in space where both are Metric3, else by their planar readings.
Difference difference(const Relation& a, const Relation& b);

/// Returns the same as a Mahalanobis distance, in standard deviations of both together: of six dimensions where both
/// are Metric3, else of three. `floor_m` and `floor_rad` are standard deviations that are added for each axis.
double sigmas_apart(const Relation& a, const Relation& b, double floor_m, double floor_rad);

/// Returns one standard deviation of a relation along its worst axes: in space of a Metric3, else of its planar
/// reading.
Difference spread_of(const Relation& relation);

}  // namespace weft
