#pragma once
#include <map>
#include <memory>
#include <vector>

#include "core/network/change.hpp"
#include "core/random.hpp"
#include "storage/memory/memory_store.hpp"
#include "tests/simulation/site.hpp"

namespace weft::simulation {

/// Makes the map that one robot would have taught by being led along a site's whole course: runs in batches, joined
/// where they come by one another, a label at each station and where each robot stands at first.
class StoredMap {
 public:
  /// Makes the map as if `teacher` had taught all of it, with labels where so many robots start.
  StoredMap(const Site& site, std::size_t robots, const RobotId& teacher, Random random);

  const std::vector<Batch>& batches() const { return batches_; }
  /// Returns the true pose of each place.
  const std::map<PlaceId, Pose2>& places() const { return places_; }
  const std::map<std::string, PlaceId>& labels() const { return labels_; }
  /// Commits everything. False: the disk refuses.
  bool write(const std::shared_ptr<storage::MemoryDisk>& disk) const;

 private:
  struct Spot {
    PlaceId place;
    Pose2 pose;
    double at_m = 0.0;  ///< along the course
  };
  using Cell = std::pair<int, int>;

  void teach_run(const Site& site, double from_m, double to_m, const RobotId& teacher, Random& random);
  void keep(const Site& site, const Spot& spot, Batch& batch, const Spot* before, Random& random);
  void join(const Spot& spot, Batch& batch);
  std::vector<const Spot*> around(const Spot& spot) const;
  PlaceId nearest(double at_m) const;

  std::vector<Batch> batches_;
  std::map<ContentHash, Bytes> contents_;
  std::map<PlaceId, Pose2> places_;
  std::map<std::string, PlaceId> labels_;
  std::vector<Spot> spots_;                         ///< along the course
  std::map<Cell, std::vector<std::size_t>> cells_;  ///< by where they lie
  double crossed_at_m_ = 0.0;                       ///< where the last lane was joined that cannot be driven over to
};

}  // namespace weft::simulation
