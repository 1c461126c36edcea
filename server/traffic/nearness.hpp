#pragma once
#include <map>
#include <vector>

#include "core/network/change.hpp"
#include "core/network/network.hpp"
#include "server/traffic/ground.hpp"

namespace weft::server {

/// A place as seen from another: how near it can be.
struct Near {
  PlaceId place;
  double clearance_m = 0.0;  ///< distance under the composed relation, less twice its standard deviation; >= 0
};

/// Which places lie around a place: breadth-first over the network by composed relations, no further than a radius.
/// Remembers what it found until the network changes there.
class Nearness {
 public:
  explicit Nearness(double radius_m) : radius_m_(radius_m) {}

  /// Sorted by place; the place itself is in it. Empty when the ground does not have the place. Valid until the
  /// next change of the network or of the radius.
  const std::vector<Near>& around(const Ground& ground, const PlaceId& place);
  /// The batch has joined the network.
  void joined(const Batch& batch);
  /// The network, or what is remembered of its past, was edited.
  void forget() { found_.clear(); }
  /// How far the search looks; growing it forgets what was found.
  void look_at_least(double radius_m);

 private:
  struct Found {
    std::vector<Near> near;
    std::vector<PlaceId> seen;  ///< everything the search came by, sorted: an edge there may change the result
  };
  Found search(const Ground& ground, const PlaceId& centre) const;

  double radius_m_;
  std::map<PlaceId, Found> found_;
};

}  // namespace weft::server
