#include "storage/sqlite/schema.hpp"

#include <array>

namespace weft::storage::sqlite {
namespace {

/// Lists the steps: n takes version n to n + 1. Released ones are never edited; docs/formats/store.md explains them.
constexpr std::array kMigrations{
    R"sql(
CREATE TABLE store (
  id            INTEGER PRIMARY KEY CHECK (id = 1),
  epoch         INTEGER NOT NULL,
  revision      INTEGER NOT NULL,
  contents      INTEGER NOT NULL,
  content_bytes INTEGER NOT NULL
);
INSERT INTO store VALUES (1, 0, 0, 0, 0);

CREATE TABLE content (
  hash        BLOB PRIMARY KEY NOT NULL,
  kind        INTEGER NOT NULL,
  size        INTEGER NOT NULL,
  coding      INTEGER NOT NULL,
  quarantined INTEGER NOT NULL DEFAULT 0,
  bytes       BLOB NOT NULL
);
CREATE INDEX content_quarantined ON content (hash) WHERE quarantined = 1;

CREATE TABLE experience (
  id              INTEGER PRIMARY KEY,
  robot           BLOB NOT NULL,
  name            TEXT NOT NULL,
  method          TEXT NOT NULL,
  sealed          INTEGER NOT NULL,
  seal_reason     TEXT NOT NULL,
  durable_through INTEGER NOT NULL,
  places          INTEGER NOT NULL
);

CREATE TABLE batch (
  experience INTEGER NOT NULL,
  sequence   INTEGER NOT NULL,
  revision   INTEGER NOT NULL,
  hash       BLOB NOT NULL,
  PRIMARY KEY (experience, sequence)
) WITHOUT ROWID;

CREATE TABLE place (
  experience INTEGER NOT NULL,
  place      INTEGER NOT NULL,
  revision   INTEGER NOT NULL,
  row        BLOB NOT NULL,
  PRIMARY KEY (experience, place)
) WITHOUT ROWID;

CREATE TABLE edge (
  a_experience INTEGER NOT NULL,
  a_place      INTEGER NOT NULL,
  b_experience INTEGER NOT NULL,
  b_place      INTEGER NOT NULL,
  revision     INTEGER NOT NULL,
  row          BLOB NOT NULL,
  PRIMARY KEY (a_experience, a_place, b_experience, b_place, revision)
) WITHOUT ROWID;

CREATE TABLE label (
  label      TEXT NOT NULL,
  revision   INTEGER NOT NULL,
  experience INTEGER NOT NULL,
  place      INTEGER NOT NULL,
  PRIMARY KEY (label, revision)
) WITHOUT ROWID;

CREATE TABLE goal (id BLOB PRIMARY KEY, row BLOB NOT NULL) WITHOUT ROWID;
CREATE TABLE route (goal BLOB PRIMARY KEY, row BLOB NOT NULL) WITHOUT ROWID;
CREATE TABLE occupancy (
  robot       BLOB PRIMARY KEY,
  first_place INTEGER NOT NULL,
  last_place  INTEGER NOT NULL,
  row         BLOB NOT NULL
) WITHOUT ROWID;
CREATE TABLE robot (id BLOB PRIMARY KEY, name TEXT NOT NULL) WITHOUT ROWID;

CREATE TABLE event (
  id    INTEGER PRIMARY KEY,
  at_ns INTEGER NOT NULL,
  kind  TEXT NOT NULL,
  robot BLOB NOT NULL,
  goal  BLOB NOT NULL,
  cause TEXT NOT NULL,
  who   TEXT NOT NULL
);
CREATE INDEX event_by_goal ON event (goal, id);
CREATE INDEX event_by_robot ON event (robot, id);
)sql",
    R"sql(
CREATE TABLE revision (
  id    INTEGER PRIMARY KEY,
  base  INTEGER NOT NULL,
  at_ns INTEGER NOT NULL,
  kind  TEXT NOT NULL,
  who   TEXT NOT NULL,
  cause TEXT NOT NULL
);
CREATE INDEX revision_rollback ON revision (id, base) WHERE base <> id - 1;
WITH RECURSIVE past (id) AS (
  SELECT revision FROM store WHERE revision > 0 UNION ALL SELECT id - 1 FROM past WHERE id > 1
)
INSERT INTO revision SELECT id, id - 1, 0, 'unknown', '', 'made before revisions were noted' FROM past;

CREATE TABLE moved_places (
  revision    INTEGER NOT NULL,
  experience  INTEGER NOT NULL,
  first_place INTEGER NOT NULL,
  last_place  INTEGER NOT NULL,
  is_back     INTEGER NOT NULL,
  PRIMARY KEY (revision, experience, first_place, is_back)
) WITHOUT ROWID;

CREATE TABLE moved_stitch (
  revision     INTEGER NOT NULL,
  a_experience INTEGER NOT NULL,
  a_place      INTEGER NOT NULL,
  b_experience INTEGER NOT NULL,
  b_place      INTEGER NOT NULL,
  is_back      INTEGER NOT NULL,
  PRIMARY KEY (revision, a_experience, a_place, b_experience, b_place, is_back)
) WITHOUT ROWID;
)sql",
    R"sql(
ALTER TABLE store ADD COLUMN floor INTEGER NOT NULL DEFAULT 0;

CREATE TABLE deleted_places (
  experience  INTEGER NOT NULL,
  first_place INTEGER NOT NULL,
  last_place  INTEGER NOT NULL,
  PRIMARY KEY (experience, first_place)
) WITHOUT ROWID;

CREATE TABLE preparation (
  methods TEXT PRIMARY KEY NOT NULL,
  hash    BLOB NOT NULL,
  bytes   BLOB NOT NULL
);
)sql",
    R"sql(
CREATE INDEX edge_by_b ON edge (b_experience) WHERE a_experience <> b_experience;
ALTER TABLE content ADD COLUMN sum INTEGER;
)sql",
    R"sql(
CREATE TABLE place_anew (
  experience INTEGER NOT NULL,
  place      INTEGER NOT NULL,
  revision   INTEGER NOT NULL,
  row        BLOB NOT NULL,
  PRIMARY KEY (experience, place, revision)
) WITHOUT ROWID;
CREATE INDEX place_anew_by_revision ON place_anew (revision);
)sql",
    // In a table WITHOUT ROWID, quick_check of SQLite 3.40 takes a NOT NULL column that stands before a later column
    // of the key for NULL. So the columns of the key come first, in its order.
    R"sql(
CREATE TABLE moved_places_anew (
  revision    INTEGER NOT NULL,
  experience  INTEGER NOT NULL,
  first_place INTEGER NOT NULL,
  is_back     INTEGER NOT NULL,
  last_place  INTEGER NOT NULL,
  PRIMARY KEY (revision, experience, first_place, is_back)
) WITHOUT ROWID;
INSERT INTO moved_places_anew (revision, experience, first_place, is_back, last_place)
  SELECT revision, experience, first_place, is_back, last_place FROM moved_places;
DROP TABLE moved_places;
ALTER TABLE moved_places_anew RENAME TO moved_places;

CREATE TABLE apart (
  one_experience   INTEGER NOT NULL,
  one_first        INTEGER NOT NULL,
  one_last         INTEGER NOT NULL,
  other_experience INTEGER NOT NULL,
  other_first      INTEGER NOT NULL,
  other_last       INTEGER NOT NULL,
  revision         INTEGER NOT NULL,
  holds            INTEGER NOT NULL,
  PRIMARY KEY (one_experience, one_first, one_last, other_experience, other_first, other_last, revision)
) WITHOUT ROWID;

CREATE TABLE rule (
  name     TEXT NOT NULL,
  revision INTEGER NOT NULL,
  holds    INTEGER NOT NULL,
  row      BLOB NOT NULL,
  PRIMARY KEY (name, revision)
) WITHOUT ROWID;

CREATE TABLE registration (
  plan     TEXT NOT NULL,
  revision INTEGER NOT NULL,
  holds    INTEGER NOT NULL,
  row      BLOB NOT NULL,
  PRIMARY KEY (plan, revision)
) WITHOUT ROWID;

CREATE TABLE hold (robot BLOB PRIMARY KEY NOT NULL, who TEXT NOT NULL) WITHOUT ROWID;

CREATE TABLE awaited_label (
  label      TEXT PRIMARY KEY NOT NULL,
  experience INTEGER NOT NULL,
  place      INTEGER NOT NULL,
  robot      BLOB NOT NULL,
  asker      BLOB NOT NULL,
  request    INTEGER NOT NULL,
  who        TEXT NOT NULL
) WITHOUT ROWID;

CREATE TABLE passes (
  experience INTEGER NOT NULL,
  piece      INTEGER NOT NULL,
  onward     INTEGER NOT NULL,
  row        BLOB NOT NULL,
  PRIMARY KEY (experience, piece, onward)
) WITHOUT ROWID;
)sql",
};

Error is_foreign(const std::filesystem::path& file, const std::string& why) {
  return {ErrorCode::corrupt, "map store " + file.string() + ": " + why +
                                  "; it is no map store of Weft. Name another directory, or move this file away"};
}

Result<void> migrate(const Database& database, std::uint64_t from) {
  auto transaction = WriteTransaction::begin(database);
  if (!transaction) return fail(transaction.error());
  for (std::uint64_t step = from; step < kMigrations.size(); ++step) {
    if (auto done = database.run(kMigrations[step]); !done) return done;
  }
  const std::string marks = "PRAGMA application_id = " + std::to_string(kApplicationId) +
                            "; PRAGMA user_version = " + std::to_string(kMigrations.size());
  if (auto done = database.run(marks); !done) return done;
  return transaction->commit();
}

}  // namespace

std::uint64_t schema_version() {
  return kMigrations.size();
}

Result<void> prepare_schema(const Database& database, const std::filesystem::path& file) {
  const auto application = database.number("PRAGMA application_id");
  if (!application && application.error().code == ErrorCode::corrupt) {
    return fail(is_foreign(file, "it is damaged or no SQLite file (" + application.error().message + ")"));
  }
  if (!application) return fail(application.error());
  const auto version = database.number("PRAGMA user_version");
  if (!version) return fail(version.error());
  const auto tables = database.number("SELECT count(*) FROM sqlite_master");
  if (!tables) return fail(tables.error());

  const bool is_empty = *application == 0 && *version == 0 && *tables == 0;
  if (!is_empty && *application != kApplicationId) {
    return fail(is_foreign(file, "its application id is " + std::to_string(*application)));
  }
  if (*version > schema_version()) {
    return fail(ErrorCode::newer, "map store " + file.string() + " has schema version " + std::to_string(*version) +
                                      ", this software reads up to " + std::to_string(schema_version()) +
                                      "; start a newer weft-server on it");
  }
  // Free pages can be given back step by step only if the file is made for it.
  if (is_empty) {
    if (auto done = database.run("PRAGMA auto_vacuum = INCREMENTAL"); !done) return done;
  }
  // The journal's mode stands in the file, so it is set before the first table; the rest holds for this connection.
  auto modes = database.run(
      "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA journal_size_limit = 67108864;"
      "PRAGMA cache_size = -32768; PRAGMA temp_store = MEMORY");
  if (!modes) return modes;
  if (*version < schema_version()) return migrate(database, *version);
  return {};
}

}  // namespace weft::storage::sqlite
