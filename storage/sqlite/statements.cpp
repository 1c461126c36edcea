#include "storage/sqlite/statements.hpp"

namespace weft::storage::sqlite {

Result<Statements> Statements::prepare(const Database& database) {
  struct Line {
    Statement Statements::*slot;
    const char* sql;
  };
  static constexpr Line kLines[] = {
      {&Statements::read_store, "SELECT epoch, revision, contents, content_bytes, floor FROM store"},
      {&Statements::write_store,
       "UPDATE store SET epoch = ?, revision = ?, contents = ?, content_bytes = ?, floor = ?"},
      {&Statements::find_experience, "SELECT durable_through, places FROM experience WHERE id = ?"},
      {&Statements::find_batch, "SELECT hash FROM batch WHERE experience = ? AND sequence = ?"},
      {&Statements::find_content, "SELECT 1 FROM content WHERE hash = ? AND quarantined = 0"},
      {&Statements::read_content, "SELECT quarantined, coding, size, bytes, sum FROM content WHERE hash = ?"},
      // A quarantined content that comes again is healed.
      {&Statements::find_edge,
       "SELECT 1 FROM edge WHERE a_experience = ? AND a_place = ? AND b_experience = ? AND b_place = ? LIMIT 1"},
      {&Statements::find_deleted, "SELECT first_place, last_place FROM deleted_places WHERE experience = ?"},
      {&Statements::put_content,
       "INSERT INTO content (hash, kind, size, coding, bytes, sum) VALUES (?, ?, ?, ?, ?, ?)"
       " ON CONFLICT (hash) DO UPDATE SET kind = excluded.kind, size = excluded.size, coding = excluded.coding,"
       " bytes = excluded.bytes, sum = excluded.sum, quarantined = 0"},
      {&Statements::put_experience,
       "INSERT INTO experience (id, robot, name, method, sealed, seal_reason, durable_through, places)"
       " VALUES (?, ?, ?, ?, ?, ?, ?, ?) ON CONFLICT (id) DO UPDATE SET"
       " seal_reason = CASE WHEN excluded.sealed THEN excluded.seal_reason ELSE seal_reason END,"
       " sealed = sealed OR excluded.sealed, durable_through = excluded.durable_through,"
       " places = places + excluded.places"},
      {&Statements::put_batch, "INSERT INTO batch (experience, sequence, revision, hash) VALUES (?, ?, ?, ?)"},
      {&Statements::put_place, "INSERT INTO place (experience, place, revision, row) VALUES (?, ?, ?, ?)"},
      {&Statements::put_place_anew,
       "INSERT OR REPLACE INTO place_anew (experience, place, revision, row) VALUES (?, ?, ?, ?)"},
      {&Statements::put_edge,
       "INSERT OR REPLACE INTO edge (a_experience, a_place, b_experience, b_place, revision, row)"
       " VALUES (?, ?, ?, ?, ?, ?)"},
      {&Statements::put_label,
       "INSERT OR REPLACE INTO label (label, revision, experience, place) VALUES (?, ?, ?, ?)"},
      {&Statements::put_apart,
       "INSERT OR REPLACE INTO apart (one_experience, one_first, one_last, other_experience, other_first, other_last,"
       " revision, holds) VALUES (?, ?, ?, ?, ?, ?, ?, ?)"},
      {&Statements::put_rule, "INSERT OR REPLACE INTO rule (name, revision, holds, row) VALUES (?, ?, ?, ?)"},
      {&Statements::put_registration,
       "INSERT OR REPLACE INTO registration (plan, revision, holds, row) VALUES (?, ?, ?, ?)"},
      {&Statements::seal, "UPDATE experience SET sealed = 1, seal_reason = ? WHERE id = ?"},
      {&Statements::put_revision,
       "INSERT INTO revision (id, base, at_ns, kind, who, cause) VALUES (?, ?, ?, ?, ?, ?)"},
      {&Statements::move_places,
       "INSERT OR REPLACE INTO moved_places (revision, experience, first_place, last_place, is_back)"
       " VALUES (?, ?, ?, ?, ?)"},
      {&Statements::move_stitch,
       "INSERT OR REPLACE INTO moved_stitch (revision, a_experience, a_place, b_experience, b_place, is_back)"
       " VALUES (?, ?, ?, ?, ?, ?)"},
      {&Statements::put_goal, "INSERT OR REPLACE INTO goal (id, row) VALUES (?, ?)"},
      {&Statements::put_route, "INSERT OR REPLACE INTO route (goal, row) VALUES (?, ?)"},
      {&Statements::put_occupancy,
       "INSERT OR REPLACE INTO occupancy (robot, first_place, last_place, row) VALUES (?, ?, ?, ?)"},
      {&Statements::free_occupancy, "DELETE FROM occupancy WHERE robot = ?"},
      {&Statements::put_robot, "INSERT OR REPLACE INTO robot (id, name) VALUES (?, ?)"},
      {&Statements::put_hold, "INSERT OR REPLACE INTO hold (robot, who) VALUES (?, ?)"},
      {&Statements::free_hold, "DELETE FROM hold WHERE robot = ?"},
      {&Statements::put_awaited_label,
       "INSERT OR REPLACE INTO awaited_label (label, experience, place, robot, asker, request, who)"
       " VALUES (?, ?, ?, ?, ?, ?, ?)"},
      {&Statements::drop_awaited_label, "DELETE FROM awaited_label WHERE label = ?"},
      {&Statements::put_passes, "INSERT OR REPLACE INTO passes (experience, piece, onward, row) VALUES (?, ?, ?, ?)"},
      {&Statements::put_event, "INSERT INTO event (at_ns, kind, robot, goal, cause, who) VALUES (?, ?, ?, ?, ?, ?)"},
      {&Statements::put_preparation, "INSERT OR REPLACE INTO preparation (methods, hash, bytes) VALUES (?, ?, ?)"},
      {&Statements::read_preparation, "SELECT hash, bytes FROM preparation WHERE methods = ?"},
      {&Statements::quarantine,
       "UPDATE content SET quarantined = 1 WHERE hash = ? AND quarantined = 0 RETURNING size"},
  };
  Statements statements;
  for (const Line& line : kLines) {
    auto statement = database.prepare(line.sql);
    if (!statement) return fail(statement.error());
    statements.*line.slot = std::move(*statement);
  }
  return statements;
}

}  // namespace weft::storage::sqlite
