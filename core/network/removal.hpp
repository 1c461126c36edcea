#pragma once
#include <cstdint>
#include <vector>

#include "core/network/network.hpp"

namespace weft {

/// Denotes consecutive places of one experience, `first` to `last`, both included.
struct Stretch {
  ExperienceId experience;
  std::uint32_t first = 0;
  std::uint32_t last = 0;
  auto operator<=>(const Stretch&) const = default;
};

/// Returns "E:I..J", as operators write it.
std::string to_string(const Stretch& stretch);

/// Lists the places and stitches that leave the network or come back to it. Places take their edges and labels along.
struct Removal {
  std::vector<Stretch> places;
  std::vector<EdgeId> stitches;
  bool empty() const { return places.empty() && stitches.empty(); }
  bool operator==(const Removal&) const = default;
};

/// Checks a removal. not_found: nothing of a stretch, or no such stitch, is in the snapshot. invalid: a stretch whose
/// first is after its last, a removal of nothing.
Result<void> check(const Snapshot& snapshot, const Removal& removal);

/// Returns the part of it that is in the snapshot, as the longest stretches, sorted; each once.
Removal present(const Snapshot& snapshot, const Removal& removal);
/// Returns the part of it that is not in the snapshot; stretches are cut to what their experiences ever had.
Removal absent(const Snapshot& snapshot, const Removal& removal);
std::uint64_t place_count(const Removal& removal);

/// Returns the snapshot without them, one revision on. Experiences stay known: nothing of them is handed in again.
Snapshot without(const Snapshot& snapshot, const Removal& removal);

}  // namespace weft
