#pragma once
#include <map>
#include <memory>
#include <vector>

#include "core/network/change.hpp"
#include "core/network/network.hpp"
#include "server/traffic/traffic_map.hpp"

namespace weft::server {

/// Tells how near a place can be to another.
struct Near {
  PlaceId place;
  double clearance_m = 0.0;  ///< distance under the composed relation, less twice its standard deviation; >= 0
};

/// Finds which places lie around a place: breadth-first over the network by composed relations, no further than a
/// radius. Remembers what it found until the network changes there.
class Nearness {
 public:
  explicit Nearness(double radius_m) : radius_m_(radius_m) {}

  using Places = std::shared_ptr<const std::vector<Near>>;
  /// Returns places sorted by id; the place itself is among them. Empty when the map does not have the place. True
  /// until the next change of the network or of the radius.
  Places around(const TrafficMap& map, const PlaceId& place);
  /// Forgets what may be different since the batch has joined the network. Returns around which places.
  std::vector<PlaceId> joined(const Batch& batch);
  /// Forgets everything: the network, or what is remembered of its history, was edited.
  void forget() { found_.clear(); }
  /// Lets the search look at least that far. Returns true when it looks farther now, and has forgotten what it found.
  bool grow_radius(double radius_m);

 private:
  struct Found {
    Places near;
    std::vector<PlaceId> seen;  ///< everything the search came by, sorted: an edge there may change the result
  };
  Found search(const TrafficMap& map, const PlaceId& centre) const;

  double radius_m_;
  std::map<PlaceId, Found> found_;
};

}  // namespace weft::server
