#pragma once
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "core/network/network.hpp"
#include "core/network/removal.hpp"

namespace weft {

/// Says by which rule a place counts as redundant: others cover it.
struct PruneRule {
  double within_m = 0.5;           ///< a place of another experience covers one that lies no farther from it
  double within_rad = 0.35;        ///< and looks no more than this another way
  std::optional<ExperienceId> by;  ///< only this experience covers; none: any
  std::set<PlaceId> keep;          ///< besides labelled places: those that robots stand on, or are to drive
};

/// Looks for places that can go without anybody missing them: each is covered by a place of another experience and
/// the same method that stays, and whoever could drive from one staying place to another through what goes can still
/// do so, by a way that is at most half as long again plus 2 m. So every label and every place that could be reached
/// stays reachable. Experiences with the fewest stitches a place go first. Works in steps, on one snapshot.
class Pruner {
 public:
  Pruner(Snapshot snapshot, PruneRule rule);

  /// Does a bounded piece of work; returns false once there is none left.
  bool step();
  std::uint64_t done() const { return done_; }  ///< places looked at
  std::uint64_t total() const { return total_; }
  const Snapshot& snapshot() const { return snapshot_; }
  /// Returns what can go, as found so far.
  const Removal& found() const { return found_; }

 private:
  struct Cover {
    bool is_covered = false;
    PlaceId by;
  };
  Cover cover_of(const Place& place) const;
  bool is_missed(const Stretch& run) const;
  void try_around_a_junction(const Stretch& run);
  void look_at_places();
  bool stays(const PlaceId& place) const { return !gone_.contains(place); }

  Snapshot snapshot_;
  PruneRule rule_;
  std::vector<ExperienceId> order_;
  std::size_t next_experience_ = 0;
  const Experience* current_ = nullptr;
  std::size_t next_place_ = 0;
  std::vector<Cover> covers_;  ///< of the current experience's places
  std::vector<Stretch> runs_;  ///< to be tried, the next one last
  std::set<PlaceId> gone_;
  std::set<PlaceId> covering_;  ///< these have to stay
  Removal found_;
  std::uint64_t done_ = 0;
  std::uint64_t total_ = 0;
};

/// Returns the runs of a pruner's findings that can still go from a later snapshot: none with a place whose edges
/// have changed since, that has a label by now, or that is in `keep`.
Removal still_unneeded(const Pruner& pruner, const Snapshot& now, const std::set<PlaceId>& keep);

/// Returns whether nothing of `before` has left.
bool only_grew(const Snapshot& before, const Snapshot& now);

/// Returns the uncompressed size, in bytes, of the contents of those places.
std::uint64_t content_bytes(const Snapshot& snapshot, const Removal& removal);

}  // namespace weft
