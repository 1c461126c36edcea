#pragma once
#include <cstdint>
#include <map>
#include <string>

namespace weft::server {

/// Counts refusals and the like, by name; shown in `map info`.
using Counters = std::map<std::string, std::uint64_t>;

}  // namespace weft::server
