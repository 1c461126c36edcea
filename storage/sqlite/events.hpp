#pragma once
#include <cstddef>

#include "core/result.hpp"
#include "storage/events.hpp"
#include "storage/sqlite/database.hpp"

namespace weft::storage::sqlite {

/// Reads events as `MapStore::events` says.
Result<EventPage> read_events(const Database& database, const EventFilter& filter, std::size_t limit);

}  // namespace weft::storage::sqlite
