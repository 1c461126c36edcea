#pragma once
#include <map>
#include <vector>

#include "core/network/network.hpp"
#include "core/protocol/messages.hpp"

namespace weft::server {

/// Returns what people want to know of each experience that has places in the map, in the order of their ids.
/// `begun`: when the first batch of each was stored, as far as that is known.
std::vector<msg::ExperienceRow> experience_rows(const Snapshot& map, const std::map<ExperienceId, WallTime>& begun);

}  // namespace weft::server
