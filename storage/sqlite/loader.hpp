#pragma once
#include <map>
#include <vector>

#include "core/result.hpp"
#include "storage/map_store.hpp"
#include "storage/sqlite/database.hpp"

namespace weft::storage::sqlite {

/// Reads everything but contents. Damaged rows are left out and named; an error only when a table cannot be read.
Result<Stored> load(const Database& database, Epoch epoch, Revision revision);

/// Loads the network alone, as it was at a revision that exists. Of `near`, the network at another revision,
/// everything is taken over that is the same; revision 0: nothing.
Result<Snapshot> load_snapshot(const Database& database, Revision revision, const Snapshot& near);

/// Loads which revision each rollback went back to.
Result<std::map<Revision, Revision>> load_bases(const Database& database);

/// Loads the notes of revisions, newest first, from `newest` down to `oldest`, at most `limit`.
Result<std::vector<RevisionNote>> load_log(const Database& database, Revision newest, Revision oldest,
                                           std::size_t limit);

/// Loads when the first batch of each experience was committed, at the revision `oldest` or later.
Result<std::map<ExperienceId, WallTime>> load_begun(const Database& database, Revision oldest);

/// Loads what a revision changed. not_found: no such revision.
Result<RevisionChanges> load_changes(const Database& database, Revision revision);

}  // namespace weft::storage::sqlite
