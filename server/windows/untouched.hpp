#pragma once
#include "core/network/window.hpp"

namespace weft::server {

/// Returns whether the window of that definition must look the same in two snapshots: a breadth-first search looks at
/// the places it finds and at their edges, all of which stand in their experiences, and revisions share experiences
/// that did not change. `window` is that of `then`, and `now` a later one. When it says no, it may still look the
/// same.
bool is_untouched(const WindowDefinition& definition, const Window& window, const Snapshot& then,
                  const Snapshot& now);

}  // namespace weft::server
