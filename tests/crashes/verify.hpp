#pragma once
#include <string>
#include <vector>

#include "tests/crashes/round.hpp"

namespace weft::crashes {

/// Opens the store as after a restart and holds it against what was promised: every acknowledged batch is there once,
/// with its contents to the byte, revisions have no gap, edits are where they were said to be, no checksum or
/// reference is broken; a finished snapshot is a sound store. Each line is a loss. What was durable and not yet
/// acknowledged is promised from now on.
std::vector<std::string> verify(const RoundPlan& plan, Promised& promised);

}  // namespace weft::crashes
