#include "storage/sqlite/sqlite_store.hpp"

#include <algorithm>
#include <limits>
#include <set>

#include "core/network/codec.hpp"
#include "storage/sqlite/directory_lock.hpp"
#include "storage/sqlite/loader.hpp"
#include "storage/sqlite/rows.hpp"
#include "storage/sqlite/schema.hpp"
#include "storage/sqlite/statements.hpp"
#include "storage/sqlite/writer.hpp"

namespace weft::storage {
namespace {

using namespace sqlite;

/// What stands open. Members go in reverse: statements before the database before the lock.
struct Parts {
  std::filesystem::path directory;
  DirectoryLock lock;
  Database database;
  Statements statements;
  Epoch epoch{};
  StoreRow row{};                       ///< as last committed
  std::set<ContentHash> quarantined{};  ///< found damaged by this process
};

msg::Event event_from_row(const Query& row) {
  msg::Event event;
  event.at = WallTime(Duration(static_cast<std::int64_t>(row.number(0))));
  event.kind = row.text(1);
  event.robot = row.id<RobotId>(2);
  event.goal = row.id<GoalId>(3);
  event.cause = row.text(4);
  event.who = row.text(5);
  return event;
}

class SqliteStore final : public MapStore {
 public:
  explicit SqliteStore(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

  Result<Stored> open() override {
    auto write = WriteTransaction::begin(parts_->database);
    if (!write) return fail(write.error());
    Result<StoreRow> row = read_store_row(parts_->statements);
    if (!row) return fail(row.error());
    ++row->epoch.value;
    if (auto done = write_store_row(parts_->statements, *row); !done) return fail(done.error());
    if (auto done = write->commit(); !done) return fail(done.error());
    parts_->epoch = row->epoch;
    parts_->row = *row;
    return load(parts_->database, row->epoch, row->revision);
  }

  Result<Commit> commit(const Transaction& transaction) override {
    auto write = WriteTransaction::begin(parts_->database);
    if (!write) return fail(write.error());
    Result<StoreRow> row = current_row();
    if (!row) return fail(row.error());
    Result<Facts> facts = read_facts(parts_->statements, needs_of(transaction));
    if (!facts) return fail(facts.error());
    for (const ContentHash& hash : parts_->quarantined) facts->contents.erase(hash);
    facts->revision = row->revision;
    const Result<Plan> plan = make_plan(transaction, *facts);
    if (!plan) return fail(plan.error());
    if (std::none_of(plan->fresh.begin(), plan->fresh.end(), [](bool fresh) { return fresh; })) {
      return Commit{row->revision};
    }
    row = write_changes(parts_->statements, transaction, *plan, *row);
    if (!row) return fail(row.error());
    if (auto done = write->commit(); !done) return fail(done.error());
    parts_->row = *row;
    for (const auto& change : transaction.changes) {
      if (const auto* put = std::get_if<PutContent>(&change)) parts_->quarantined.erase(put->hash);
    }
    return Commit{row->revision};
  }

  bool has_content(const ContentHash& hash) const override {
    if (parts_->quarantined.contains(hash)) return false;
    Query query(parts_->statements.find_content);
    query << hash;
    return query.step().value_or(false);
  }

  Result<Bytes> content(const ContentHash& hash) const override {
    const std::string name = "content " + to_string(hash);
    Result<Bytes> bytes = read_content(hash);
    if (!bytes) {
      if (bytes.error().code != ErrorCode::corrupt)
        return fail(bytes.error().code, name + ": " + bytes.error().message);
      quarantine(hash);
      return fail(ErrorCode::corrupt, name + " is damaged and quarantined: " + bytes.error().message);
    }
    return bytes;
  }

  std::optional<ContentHash> batch_hash(ExperienceId experience, std::uint64_t sequence) const override {
    Query query(parts_->statements.find_batch);
    query << experience.value << sequence;
    if (!query.step().value_or(false)) return std::nullopt;
    return query.id<ContentHash>(0);
  }

  Result<std::vector<msg::Event>> events(const GoalId& goal, const RobotId& robot, std::size_t limit) const override {
    const Statements& all = parts_->statements;
    Query query(goal && robot ? all.events_of_both
                : goal        ? all.events_of_goal
                : robot       ? all.events_of_robot
                              : all.events);
    if (goal) query << goal;
    if (robot) query << robot;
    query << std::uint64_t{std::min<std::size_t>(limit, std::numeric_limits<std::int64_t>::max())};
    std::vector<msg::Event> found;
    for (;;) {
      const Result<bool> row = query.step();
      if (!row) return fail(row.error());
      if (!*row) break;
      found.push_back(event_from_row(query));
    }
    std::reverse(found.begin(), found.end());
    return found;
  }

  Result<Snapshot> snapshot_at(Revision revision) const override {
    if (auto there = check_revision(revision); !there) return fail(there.error());
    return load_snapshot(parts_->database, revision);
  }

  Result<std::vector<RevisionNote>> log(Revision newest, std::size_t limit) const override {
    return load_log(parts_->database, newest.value == 0 ? parts_->row.revision : newest, limit);
  }

  Result<RevisionChanges> changes_of(Revision revision) const override {
    if (auto there = check_revision(revision); !there) return fail(there.error());
    return load_changes(parts_->database, revision);
  }

  StoreSize size() const override {
    std::error_code unknown;
    const auto space = std::filesystem::space(parts_->directory, unknown);
    return {.contents = parts_->row.contents,
            .content_bytes = parts_->row.content_bytes,
            .disk_free_bytes = unknown ? 0 : space.available};
  }

  std::string engine() const override { return "sqlite"; }

 private:
  /// stale: another server has opened the store since.
  Result<StoreRow> current_row() const {
    Result<StoreRow> row = read_store_row(parts_->statements);
    if (row && row->epoch != parts_->epoch) {
      return fail(ErrorCode::stale, "map store " + parts_->directory.string() + ": epoch " +
                                        std::to_string(parts_->epoch.value) +
                                        " has ended, another server opened the store with epoch " +
                                        std::to_string(row->epoch.value) + "; stop this one");
    }
    return row;
  }

  Result<void> check_revision(Revision revision) const {
    if (revision <= parts_->row.revision) return {};
    return fail(ErrorCode::not_found, "the map has no revision " + std::to_string(revision.value) +
                                          "; its newest is " + std::to_string(parts_->row.revision.value));
  }

  Result<Bytes> read_content(const ContentHash& hash) const {
    Query query(parts_->statements.read_content);
    query << hash;
    const Result<bool> found = query.step();
    if (!found) return fail(found.error());
    if (!*found) return fail(ErrorCode::not_found, "it is not stored");
    if (query.number(0) != 0) return fail(ErrorCode::corrupt, "it was found damaged before");
    Result<Bytes> bytes = decode_content(static_cast<Coding>(query.number(1)), query.blob(3), query.number(2));
    if (bytes && hash_bytes(*bytes) != hash) return fail(ErrorCode::corrupt, "its SHA-256 differs");
    return bytes;
  }

  /// Marks the row, so that it stays named after a restart. When the disk takes no mark, this process remembers.
  void quarantine(const ContentHash& hash) const {
    if (!parts_->quarantined.insert(hash).second) return;
    auto write = WriteTransaction::begin(parts_->database);
    if (!write) return;
    Result<StoreRow> row = current_row();
    if (!row) return;
    {
      Query query(parts_->statements.quarantine);
      query << hash;
      if (!query.step().value_or(false)) return;
      --row->contents;
      row->content_bytes -= query.number(0);
      if (!query.step()) return;  // RETURNING: the statement ends with the step after its row
    }
    if (write_store_row(parts_->statements, *row) && write->commit()) parts_->row = *row;
  }

  std::unique_ptr<Parts> parts_;
};

}  // namespace

Result<std::unique_ptr<MapStore>> open_sqlite(const std::filesystem::path& directory, const SqliteOptions& options) {
  auto lock = DirectoryLock::take(directory);
  if (!lock) return fail(lock.error());
  const std::filesystem::path file = directory / "map.sqlite";
  auto database = Database::open(file, options.vfs);
  if (!database) return fail(database.error());
  if (auto done = prepare_schema(*database, file); !done) return fail(done.error());
  auto statements = Statements::prepare(*database);
  if (!statements) return fail(statements.error());
  return std::make_unique<SqliteStore>(
      std::make_unique<Parts>(Parts{directory, std::move(*lock), std::move(*database), std::move(*statements)}));
}

}  // namespace weft::storage
