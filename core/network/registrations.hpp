#pragma once
#include <string>

#include "core/network/network.hpp"
#include "core/result.hpp"

namespace weft {

/// Returns nothing for a registration that fits the map. invalid: a name of the plan or of a pick that breaks the
/// rule for names, no pick or too many, a number out of its bound, one registration too many. not_found: the snapshot
/// has not the place.
Result<void> check(const Snapshot& snapshot, const Registration& registration);

/// Return the snapshot with the registration, in the place of one of its plan, or without the one of that plan; one
/// revision on.
Snapshot with_registration(const Snapshot& snapshot, const Registration& registration);
Snapshot without_registration(const Snapshot& snapshot, const std::string& plan);

}  // namespace weft
