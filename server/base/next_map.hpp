#pragma once
#include <optional>

#include "core/network/network.hpp"
#include "storage/map_store.hpp"

namespace weft::server {

/// Returns the map that the transaction makes of `map`, one revision on. It costs what the transaction changes. None:
/// this cannot be told from the map in memory, or the transaction changes several things of the map or nothing; then
/// the map is read from the store. The caller has checked the change, and the store has taken it.
std::optional<Snapshot> next_map(const Snapshot& map, const storage::Transaction& transaction);

}  // namespace weft::server
