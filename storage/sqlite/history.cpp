#include <algorithm>
#include <set>
#include <string>

#include "core/network/codec.hpp"
#include "storage/sqlite/loader.hpp"
#include "storage/sqlite/row_reading.hpp"

/// Reads single revisions: the log of the map, and what one of them changed.
namespace weft::storage::sqlite {
namespace {

RevisionNote note_from(const Query& row) {
  return {.revision = {row.number(0)},
          .base = {row.number(1)},
          .at = WallTime(Duration(static_cast<std::int64_t>(row.number(2)))),
          .kind = row.text(3),
          .who = row.text(4),
          .cause = row.text(5)};
}

/// Returns the experiences whose batches the revision took: they are few, and rows are found by their experience.
Result<std::set<ExperienceId>> grown_at(const Database& database, std::uint64_t revision) {
  std::set<ExperienceId> grown;
  const auto done = for_each_row(
      database, "SELECT DISTINCT experience FROM batch WHERE revision = ?",
      [&](const Query& row) { grown.insert({row.number(0)}); }, revision);
  if (!done) return fail(done.error());
  return grown;
}

Result<void> read_added(const Database& database, std::uint64_t revision, Removal& added) {
  const auto grown = grown_at(database, revision);
  if (!grown) return fail(grown.error());
  for (const ExperienceId experience : *grown) {
    auto done = for_each_row(
        database,
        "SELECT experience, min(place), max(place) FROM place WHERE experience = ? AND revision = ?"
        " GROUP BY experience",
        [&](const Query& row) {
          added.places.push_back({{row.number(0)},
                                  static_cast<std::uint32_t>(row.number(1)),
                                  static_cast<std::uint32_t>(row.number(2))});
        },
        experience.value, revision);
    if (!done) return done;
    const auto add_stitch = [&](const Query& row) { added.stitches.push_back({place_id(row, 0), place_id(row, 2)}); };
    // A stitch's b is in the experience whose batch brought it.
    done = for_each_row(database,
                        "SELECT a_experience, a_place, b_experience, b_place FROM edge WHERE a_experience = ?1"
                        " AND b_experience = ?1 AND b_place <> a_place + 1 AND revision = ?2",
                        add_stitch, experience.value, revision);
    if (!done) return done;
    done = for_each_row(database,
                        "SELECT a_experience, a_place, b_experience, b_place FROM edge WHERE b_experience = ?"
                        " AND a_experience <> b_experience AND revision = ?",
                        add_stitch, experience.value, revision);
    if (!done) return done;
  }
  std::ranges::sort(added.stitches);
  return {};
}

Result<void> read_moved(const Database& database, std::uint64_t revision, RevisionChanges& changes) {
  const auto side = [&](const Query& row, int column) -> Removal& {
    return row.number(column) != 0 ? changes.brought_back : changes.taken_out;
  };
  auto done = for_each_row(
      database, "SELECT experience, first_place, last_place, is_back FROM moved_places WHERE revision = ?",
      [&](const Query& row) {
        side(row, 3).places.push_back(
            {{row.number(0)}, static_cast<std::uint32_t>(row.number(1)), static_cast<std::uint32_t>(row.number(2))});
      },
      revision);
  if (!done) return done;
  return for_each_row(
      database, "SELECT a_experience, a_place, b_experience, b_place, is_back FROM moved_stitch WHERE revision = ?",
      [&](const Query& row) {
        side(row, 4).stitches.push_back({place_id(row, 0), place_id(row, 2)});
      },
      revision);
}

Result<void> read_known_anew(const Database& database, std::uint64_t revision, std::vector<Place>& places) {
  Result<void> damaged;
  auto done = for_each_row(
      database, "SELECT row FROM place_anew WHERE revision = ? ORDER BY experience, place",
      [&](const Query& row) {
        Result<Place> place = decode_guarded(row.blob(0), decode_place);
        if (place) {
          places.push_back(std::move(*place));
        } else {
          damaged = fail(place.error());
        }
      },
      revision);
  return done ? damaged : done;
}

}  // namespace

Result<std::vector<RevisionNote>> load_log(const Database& database, Revision newest, Revision oldest,
                                           std::size_t limit) {
  std::vector<RevisionNote> notes;
  const auto done = for_each_row(
      database,
      "SELECT id, base, at_ns, kind, who, cause FROM revision WHERE id <= ? AND id >= ? ORDER BY id DESC LIMIT ?",
      [&](const Query& row) { notes.push_back(note_from(row)); }, newest.value, oldest.value,
      std::uint64_t{std::min<std::size_t>(limit, 1'000'000)});
  if (!done) return fail(done.error());
  return notes;
}

Result<std::map<ExperienceId, WallTime>> load_begun(const Database& database, Revision oldest) {
  std::map<ExperienceId, WallTime> begun;
  const auto done = for_each_row(
      database,
      "SELECT batch.experience, revision.at_ns FROM batch JOIN revision ON revision.id = batch.revision"
      " WHERE batch.sequence = 1 AND revision.id >= ? AND revision.at_ns <> 0",
      [&](const Query& row) {
        begun[{row.number(0)}] = WallTime(Duration(static_cast<std::int64_t>(row.number(1))));
      },
      oldest.value);
  if (!done) return fail(done.error());
  return begun;
}

Result<RevisionChanges> load_changes(const Database& database, Revision revision) {
  RevisionChanges changes;
  Result<void> done = for_each_row(
      database, "SELECT id, base, at_ns, kind, who, cause FROM revision WHERE id = ?",
      [&](const Query& row) { changes.note = note_from(row); }, revision.value);
  if (done && changes.note.revision != revision) {
    return fail(ErrorCode::not_found, "the map has no revision " + std::to_string(revision.value));
  }
  if (done) done = read_added(database, revision.value, changes.added);
  if (done) done = read_moved(database, revision.value, changes);
  if (done) done = read_known_anew(database, revision.value, changes.known_anew);
  if (!done) return fail(done.error());
  done = for_each_row(
      database, "SELECT label FROM label WHERE revision = ?",
      [&](const Query& row) { changes.labels.insert(row.text(0)); }, revision.value);
  if (done) {
    done = for_each_row(
        database, std::string("SELECT ") + kApartColumns + " FROM apart WHERE revision = ?",
        [&](const Query& row) { changes.aparts.insert(apart(row)); }, revision.value);
  }
  if (done) {
    done = for_each_row(
        database, "SELECT name FROM rule WHERE revision = ?",
        [&](const Query& row) { changes.rules.insert(row.text(0)); }, revision.value);
  }
  if (done) {
    done = for_each_row(
        database, "SELECT plan FROM registration WHERE revision = ?",
        [&](const Query& row) { changes.registrations.insert(row.text(0)); }, revision.value);
  }
  if (!done) return fail(done.error());
  return changes;
}

}  // namespace weft::storage::sqlite
