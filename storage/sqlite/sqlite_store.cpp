#include "storage/sqlite/sqlite_store.hpp"

#include <algorithm>
#include <limits>

#include "core/network/codec.hpp"
#include "storage/sqlite/checkpointer.hpp"
#include "storage/sqlite/events.hpp"
#include "storage/sqlite/jobs.hpp"
#include "storage/sqlite/loader.hpp"
#include "storage/sqlite/parts.hpp"
#include "storage/sqlite/schema.hpp"

namespace weft::storage {
namespace {

using namespace sqlite;

class SqliteStore final : public MapStore {
 public:
  explicit SqliteStore(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}

  void empty_log_by(std::unique_ptr<Checkpointer> checkpointer) {
    checkpointer_ = std::move(checkpointer);
    parts_->database.watch_log([by = checkpointer_.get()](std::uint64_t pages) { return by->log_has(pages); });
  }

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
    Result<StoreRow> row = current_row(*parts_);
    if (!row) return fail(row.error());
    Result<Facts> facts = read_facts(parts_->statements, needs_of(transaction));
    if (!facts) return fail(facts.error());
    for (const ContentHash& hash : parts_->quarantined) facts->contents.erase(hash);
    facts->revision = row->revision;
    facts->floor = row->floor;
    const Result<Plan> plan = make_plan(transaction, *facts);
    if (!plan) return fail(plan.error());
    if (std::none_of(plan->fresh.begin(), plan->fresh.end(), [](bool fresh) { return fresh; })) {
      return Commit{row->revision};
    }
    row = write_changes(parts_->statements, *parts_->coder, transaction, *plan, *row);
    if (!row) return fail(row.error());
    if (auto done = write->commit(); !done) return fail(done.error());
    parts_->row = *row;
    remember(transaction);
    return Commit{row->revision};
  }

  bool has_content(const ContentHash& hash) const override {
    if (parts_->quarantined.contains(hash)) return false;
    Query query(parts_->statements.find_content);
    query << hash;
    return query.step().value_or(false);
  }

  Result<Bytes> content(const ContentHash& hash) const override {
    return quarantined_if_corrupt(hash, read_content(*parts_, hash));
  }

  Result<StoredContent> stored_content(const ContentHash& hash) const override {
    return quarantined_if_corrupt(hash, read_stored(*parts_, hash));
  }

  std::optional<ContentHash> batch_hash(ExperienceId experience, std::uint64_t sequence) const override {
    Query query(parts_->statements.find_batch);
    query << experience.value << sequence;
    if (!query.step().value_or(false)) return std::nullopt;
    return query.id<ContentHash>(0);
  }

  Result<EventPage> events(const EventFilter& filter, std::size_t limit) const override {
    return read_events(parts_->database, filter, limit);
  }

  Result<Snapshot> snapshot_at(Revision revision, const Snapshot& near) const override {
    if (auto there = check_revision("map", revision); !there) return fail(there.error());
    return load_snapshot(parts_->database, revision, near);
  }

  Result<std::vector<RevisionNote>> log(Revision newest, std::size_t limit) const override {
    const Revision from = newest.value == 0 ? parts_->row.revision : newest;
    if (auto kept = check_kept("log", from, parts_->row.floor); !kept) return fail(kept.error());
    return load_log(parts_->database, from, parts_->row.floor, limit);
  }

  Result<std::map<ExperienceId, WallTime>> begun() const override {
    return load_begun(parts_->database, parts_->row.floor);
  }

  Result<RevisionChanges> changes_of(Revision revision) const override {
    if (auto there = check_revision("changes", revision); !there) return fail(there.error());
    if (auto known = check_changes_kept(revision, parts_->row.floor); !known) return fail(known.error());
    return load_changes(parts_->database, revision);
  }

  Result<Bytes> preparation(const std::string& methods) const override {
    Query query(parts_->statements.read_preparation);
    query << std::string_view(methods);
    const Result<bool> found = query.step();
    if (!found) return fail(found.error());
    if (!*found) return fail(ErrorCode::not_found, "preparation for " + methods + " is not stored");
    const ByteView bytes = query.blob(1);
    if (hash_bytes(bytes) != query.id<ContentHash>(0)) {
      return fail(ErrorCode::corrupt,
                  "preparation for " + methods + " is damaged: its SHA-256 differs; make it anew");
    }
    return Bytes(bytes.begin(), bytes.end());
  }

  Result<std::unique_ptr<StoreJob>> check() override { return make_check(*parts_); }
  Result<std::unique_ptr<StoreJob>> snapshot_to(const std::filesystem::path& file) override {
    return make_snapshot(*parts_, file);
  }

  Result<std::unique_ptr<StoreJob>> verify(const std::filesystem::path& file, const Snapshot& live) override {
    return make_verification(file, live);
  }

  Result<std::unique_ptr<StoreJob>> compact(Revision before) override { return make_compaction(*parts_, before); }
  Result<std::unique_ptr<StoreJob>> stats() override { return make_stats(*parts_); }

  StoreSize size() const override {
    std::error_code unknown;
    const auto space = std::filesystem::space(parts_->directory, unknown);
    return {.contents = parts_->row.contents,
            .content_bytes = parts_->row.content_bytes,
            .disk_free_bytes = unknown ? 0 : space.available,
            .floor = parts_->row.floor};
  }

  std::string engine() const override { return "sqlite"; }

 private:
  template <class Read>
  Result<Read> quarantined_if_corrupt(const ContentHash& hash, Result<Read> read) const {
    if (read) return read;
    const std::string name = "content " + to_string(hash);
    if (read.error().code != ErrorCode::corrupt) return fail(read.error().code, name + ": " + read.error().message);
    quarantine(*parts_, hash);
    return fail(ErrorCode::corrupt, name + " is damaged and quarantined: " + read.error().message);
  }

  /// Notes what a committed transaction has changed for work that goes on between commits: contents that are whole
  /// again, contents that a compaction must keep, moves.
  void remember(const Transaction& transaction) const {
    const auto used = parts_->used_meanwhile.lock();
    for (const auto& change : transaction.changes) {
      if (const auto* put = std::get_if<PutContent>(&change)) {
        parts_->quarantined.erase(put->hash);
        if (used) used->insert(put->hash);
      } else if (const auto* append = std::get_if<AppendBatch>(&change); append != nullptr && used) {
        for_each_place(append->batch, [&](const Place& place) { used->insert(place.content.hash); });
      } else if (const auto* anew = std::get_if<PutPlaces>(&change); anew != nullptr && used) {
        for (const Place& place : anew->places) used->insert(place.content.hash);
      } else if (std::holds_alternative<TakeOut>(change) || std::holds_alternative<BringBack>(change)) {
        ++parts_->moves;
      }
    }
  }

  Result<void> check_revision(const std::string& what, Revision revision) const {
    if (revision <= parts_->row.revision) return check_kept(what, revision, parts_->row.floor);
    return fail(ErrorCode::not_found, "the map has no revision " + std::to_string(revision.value) +
                                          "; its newest is " + std::to_string(parts_->row.revision.value));
  }

  std::unique_ptr<Parts> parts_;
  std::unique_ptr<Checkpointer> checkpointer_;  ///< ends before the rest does; none: SQLite's own way
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
  auto store = std::make_unique<SqliteStore>(std::make_unique<Parts>(
      Parts{directory, options.vfs, std::move(*lock), std::move(*database), std::move(*statements)}));
  if (options.empties_log_aside) {
    auto checkpointer = Checkpointer::start(file, options.vfs);
    if (!checkpointer) return fail(checkpointer.error());
    store->empty_log_by(std::move(*checkpointer));
  }
  return store;
}

}  // namespace weft::storage
