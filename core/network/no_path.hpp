#pragma once
#include <set>
#include <string>

#include "core/ids.hpp"

namespace weft {

/// Returns what the message of a path that does not exist begins with: from where to where, driven with which
/// methods.
std::string no_path_text(const PlaceId& from, const PlaceId& to, const std::set<std::string>& methods);

}  // namespace weft
