#pragma once
#include <string>

#include "core/network/network.hpp"
#include "core/network/removal.hpp"

namespace weft {

/// Holds an operator's word that two stretches are different floors although the network's relations may not tell:
/// robots on the one need not wait for robots on the other. Part of a map as long as each stretch has a place in it.
struct Apart {
  Stretch one;
  Stretch other;
  auto operator<=>(const Apart&) const = default;
};

/// Puts the two stretches in their order, so that a pair is the same whichever was named first.
Apart ordered(Apart apart);
/// Returns "E:I..J F:K..L".
std::string to_string(const Apart& apart);

/// Checks a pair before it joins the map. invalid: a stretch whose first is after its last, stretches that share a
/// place. not_found: a stretch of which no place is in the snapshot, or that ends behind its experience's last place.
/// conflict: it is vouched for already.
Result<void> check(const Snapshot& snapshot, const Apart& apart);

/// Returns whether each of the two stretches has a place in the snapshot.
bool is_served(const Snapshot& snapshot, const Apart& apart);
/// Returns whether somebody vouched that the two places, in either order, are on different floors. Looks at each pair
/// of stretches once: an operator names few.
bool are_apart(const Snapshot& snapshot, const PlaceId& a, const PlaceId& b);

/// Return the snapshot with the pair vouched for, or no longer, one revision on. Caller has checked it.
Snapshot with_apart(const Snapshot& snapshot, const Apart& apart);
Snapshot without_apart(const Snapshot& snapshot, const Apart& apart);

}  // namespace weft
