#pragma once
#include <string>
#include <vector>

#include "core/names.hpp"
#include "core/network/network.hpp"

namespace weft {

inline constexpr std::size_t kBatchPlaces = 1000;               ///< most places in one batch
inline constexpr std::size_t kBatchEdges = 8000;                ///< most edges in one batch
inline constexpr std::size_t kLongestReason = 256;              ///< bytes of a seal's reason, printable UTF-8
inline constexpr std::uint64_t kLargestContent = 64ULL << 20U;  ///< bytes of one content

/// Holds consecutive places of one experience and the relations that join them to what the map already has. It is the
/// unit of acknowledgement: durable as a whole with its contents, or not at all.
struct Batch {
  ExperienceId experience;
  std::uint64_t sequence = 0;  ///< from 1, without gaps, within the experience
  RobotId robot;
  std::string name;  ///< the experience's label
  std::string method;
  std::vector<Place> places;  ///< contiguous, continuing the experience
  /// Holds places of other experiences as they are known better now: their next entity version. They travel and are
  /// stored behind the batch's own places.
  std::vector<Place> learned;
  std::vector<Edge> edges;  ///< odometry chain continuing the experience, and stitches
  bool seal = false;        ///< nothing follows
  std::string seal_reason;
};

/// Visits a batch's own places, then what it has learned.
template <class Visit>
void for_each_place(const Batch& batch, Visit&& visit) {
  for (const Place& place : batch.places) visit(place);
  for (const Place& place : batch.learned) visit(place);
}
/// Sets the batch's places from `all`, as they travel: those of other experiences, at the end, become `learned`.
void set_places(Batch& batch, std::vector<Place> all);

/// Returns the SHA-256 of the batch's canonical bytes: same sequence and hash is a repeat, another hash is refused.
ContentHash hash(const Batch& batch);

/// Returns every reason for which a batch cannot join the snapshot, for intake: wrong or missing ids, gaps, cycles in
/// odometry, relations that are none, ends that do not exist, sizes out of bounds. Empty means it fits.
std::vector<Error> check(const Snapshot& snapshot, const Batch& batch);

/// Returns the batch without what it has learned too late: places that are gone, or that somebody else has come to
/// know better meanwhile.
Batch in_time(const Snapshot& snapshot, Batch batch);

/// Returns the snapshot with the batch joined, one revision on; without stitches to places that have been taken out.
/// Caller has checked the batch.
Snapshot with(const Snapshot& snapshot, const Batch& batch);
/// Returns the snapshot with the label set or moved, one revision on. Caller has checked that the place exists.
Snapshot with_label(const Snapshot& snapshot, const std::string& label, const PlaceId& place);
/// Returns the snapshot with the experience sealed for a reason, one revision on.
Snapshot with_seal(const Snapshot& snapshot, ExperienceId experience, const std::string& reason);

}  // namespace weft
