#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/random.hpp"
#include "storage/map_store.hpp"
#include "tests/storage/sample_map.hpp"

namespace weft::storage::sample {

/// Draws what a fleet and its operators do to a map, step by step: batches of several runs that are stitched, labels,
/// rules, registrations, aparts, what is taken out and brought back, rollbacks to `oldest` or later. Same seed and
/// same maps, same steps.
class RandomHistory {
 public:
  explicit RandomHistory(std::uint64_t seed) : random_(seed) {}

  struct Step {
    Transaction transaction;
    std::optional<Snapshot> expected;  ///< where core can say it: the map after it
  };
  /// Draws a step. None: this draw does not fit the map.
  std::optional<Step> draw(const Snapshot& now, Revision oldest = {});

 private:
  PlaceId pick(const Snapshot& now);
  std::optional<Step> draw_batch(const Snapshot& now, const PlaceId& joined);
  Step draw_registration(const Snapshot& now, const PlaceId& place);
  Step draw_rule(const Snapshot& now, const PlaceId& place);
  std::optional<Step> draw_apart(const Snapshot& now, const PlaceId& one);
  Step draw_removal(const Snapshot& now, const PlaceId& place);

  Random random_;
  std::vector<Run> runs_;
  std::uint64_t next_run_ = 1;
  std::vector<Removal> out_;
};

}  // namespace weft::storage::sample
