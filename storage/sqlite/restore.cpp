#include "storage/sqlite/restore.hpp"

#include <unistd.h>

#include <optional>

#include "storage/sqlite/files.hpp"
#include "storage/sqlite/jobs.hpp"
#include "storage/sqlite/parts.hpp"
#include "storage/sqlite/schema.hpp"

namespace weft::storage {
namespace {

using namespace sqlite;

/// Is the epoch that the replaced map is taken to have where its own cannot be read: more than any server has had.
constexpr std::uint64_t kEpochsUnknown = 1U << 20U;
constexpr std::size_t kNamed = 10;

Result<std::uint64_t> has_sound_pages(const Database& database) {
  return database.number("SELECT count(*) = 1 AND min(quick_check) = 'ok' FROM pragma_quick_check(1)");
}

bool is_of_older_schema(const Database& database) {
  return database.number("PRAGMA application_id").value_or(0) == kApplicationId &&
         database.number("PRAGMA user_version").value_or(schema_version()) < schema_version();
}

class Restoring {
 public:
  Restoring(const std::filesystem::path& snapshot, const std::filesystem::path& directory,
            const RestoreOptions& options)
      : options_(options),
        snapshot_(snapshot),
        directory_(directory),
        map_(directory / "map.sqlite"),
        copy_(directory / "map.sqlite.restoring"),
        what_("restore of " + snapshot.string()) {}

  Result<Restored> run() {
    auto lock = DirectoryLock::take(directory_);
    if (!lock) return fail(lock.error());
    Result<void> done = copy();
    if (done) done = check(std::move(*lock));
    if (done) done = finish_copy();
    if (!done) remove_database(copy_);
    if (done) done = replace();
    parts_.reset();
    if (!done) return fail(done.error());
    return std::move(restored_);
  }

 private:
  bool stops() const { return options_.stops && options_.stops(); }
  /// Reports progress. Returns false when nobody wants it any more.
  bool tell(const std::string& stage, std::uint64_t done, std::uint64_t total, const std::string& unit) const {
    if (options_.progress) options_.progress({stage, done, total, unit});
    return !stops();
  }

  Error stopped() const { return {ErrorCode::unavailable, what_ + ": it was stopped. Nothing was replaced"}; }

  Result<void> copy() {
    remove_database(copy_);  // of a restore that was killed
    std::error_code none;
    if (std::filesystem::file_size(snapshot_.string() + "-wal", none) > 0 && !none) {
      return fail(ErrorCode::refused, what_ +
                                          ": it has a write-ahead log beside it, so it is a store in use or one that "
                                          "was not closed, no snapshot; start a server on it, or take a snapshot");
    }
    return copy_file(what_, snapshot_, copy_,
                     [&](std::uint64_t done, std::uint64_t total) { return tell("copy", done, total, "bytes"); });
  }

  Result<void> open_copy(DirectoryLock lock) {
    auto database = Database::open(copy_, "");
    if (!database) return fail(database.error());
    if (options_.stops) database->stop_when(options_.stops);
    tell("look at pages", 0, 1, "file");
    auto is_sound = has_sound_pages(*database);
    if (is_sound && *is_sound == 0 && is_of_older_schema(*database)) {
      // Up to schema 5 the look found damage in sound rows (schema.cpp); of the newest it does not.
      if (auto done = prepare_schema(*database, snapshot_); done) is_sound = has_sound_pages(*database);
    }
    if (stops()) return fail(stopped());
    if (!is_sound || *is_sound == 0) {
      return fail(ErrorCode::corrupt, what_ + ": its pages are damaged or it is no SQLite file" +
                                          (is_sound ? "" : " (" + is_sound.error().message + ")") +
                                          "; name another snapshot. Nothing was replaced");
    }
    const auto tables = database->number("SELECT count(*) FROM sqlite_master");
    if (!tables || *tables == 0) return fail(ErrorCode::corrupt, what_ + ": it is empty, no snapshot");
    if (auto done = prepare_schema(*database, snapshot_); !done) return done;
    const auto vacuum = database->number("PRAGMA auto_vacuum");
    if (!vacuum) return fail(vacuum.error());
    if (*vacuum != 2) {  // made by an older schema
      if (auto done = database->run("PRAGMA auto_vacuum = INCREMENTAL; VACUUM"); !done) return done;
    }
    auto statements = Statements::prepare(*database);
    if (!statements) return fail(statements.error());
    parts_ =
        std::make_unique<Parts>(Parts{directory_, "", std::move(lock), std::move(*database), std::move(*statements)});
    const auto row = read_store_row(parts_->statements);
    if (!row) return fail(row.error());
    parts_->row = *row;
    parts_->epoch = row->epoch;
    return {};
  }

  Result<void> check(DirectoryLock lock) {
    if (auto done = open_copy(std::move(lock)); !done) return done;
    const auto job = make_check(*parts_);
    if (!job) return fail(job.error());
    for (bool finished = false; !finished;) {
      const auto progress = (*job)->step();
      if (!progress) return fail(progress.error());
      if (!tell("check", progress->done, progress->total, progress->unit)) return fail(stopped());
      const auto& found = progress->findings;
      restored_.findings.insert(restored_.findings.end(), found.begin(), found.end());
      finished = progress->finished;
    }
    if (restored_.findings.empty() || options_.accept_damage) return {};
    std::string named;
    for (std::size_t at = 0; at < std::min(kNamed, restored_.findings.size()); ++at) {
      named += "\n  " + restored_.findings[at];
    }
    return fail(ErrorCode::corrupt, what_ + ": " + std::to_string(restored_.findings.size()) +
                                        " things in it are damaged; take another snapshot, or accept the damage. "
                                        "Nothing was replaced:" +
                                        named);
  }

  /// Returns the epoch of the map that is there; none: there is no map.
  std::optional<std::uint64_t> epoch_there() {
    std::error_code ignored;
    if (!std::filesystem::exists(map_, ignored)) return std::nullopt;
    auto database = Database::open(map_, "");
    if (!database) return kEpochsUnknown;
    const auto epoch = database->number("SELECT epoch FROM store");
    // Afterwards its log is empty, and nothing of it can be taken for the new map's.
    is_log_empty_ = database->number("PRAGMA wal_checkpoint(TRUNCATE)").value_or(1) == 0;
    return epoch.value_or(kEpochsUnknown);
  }

  Result<void> finish_copy() {
    StoreRow row = parts_->row;
    row.epoch.value = std::max(row.epoch.value, epoch_there().value_or(0)) + 1;
    if (auto done = write_store_row(parts_->statements, row); !done) return done;
    if (auto done = parts_->database.run("PRAGMA wal_checkpoint(TRUNCATE)"); !done) return done;
    restored_.epoch = row.epoch;
    restored_.revision = row.revision;
    parts_->statements = {};
    parts_->database = {};  // closed, it is one file
    ::unlink((copy_.string() + "-wal").c_str());
    ::unlink((copy_.string() + "-shm").c_str());
    if (auto done = sync_file(what_, copy_); !done) return done;
    return sync_directory(what_, directory_);
  }

  /// Puts the new map in the old one's place. The old one gets a second name before the new one takes its first.
  Result<void> replace() {
    std::error_code ignored;
    tell("replace", 0, 3, "steps");
    if (std::filesystem::exists(map_, ignored)) {
      const std::filesystem::path aside = free_name();
      if (::link(map_.c_str(), aside.c_str()) != 0) return fail(file_error(what_, aside, "keep the old map as"));
      restored_.kept_aside = aside;
      // A log of a map that cannot be opened goes with it: beside the new map it would be taken for its own.
      const std::string log = map_.string() + "-wal";
      if (!is_log_empty_ && std::filesystem::exists(log, ignored)) {
        if (::rename(log.c_str(), (aside.string() + "-wal").c_str()) != 0)
          return fail(file_error(what_, log, "move"));
      }
    }
    ::unlink((map_.string() + "-wal").c_str());
    ::unlink((map_.string() + "-shm").c_str());
    if (auto done = sync_directory(what_, directory_); !done) return done;
    tell("replace", 1, 3, "steps");
    if (::rename(copy_.c_str(), map_.c_str()) != 0) return fail(file_error(what_, map_, "replace"));
    tell("replace", 2, 3, "steps");
    if (auto done = sync_directory(what_, directory_); !done) return done;
    tell("replace", 3, 3, "steps");
    return {};
  }

  std::filesystem::path free_name() const {
    std::error_code ignored;
    for (int number = 1;; ++number) {
      std::filesystem::path name = map_.string() + ".replaced-" + std::to_string(number);
      if (!std::filesystem::exists(name, ignored)) return name;
    }
  }

  const RestoreOptions& options_;
  std::filesystem::path snapshot_;
  std::filesystem::path directory_;
  std::filesystem::path map_;
  std::filesystem::path copy_;
  std::string what_;
  std::unique_ptr<Parts> parts_;  ///< of the copy; holds the directory's lock
  bool is_log_empty_ = true;
  Restored restored_;
};

}  // namespace

Result<Restored> restore(const std::filesystem::path& snapshot, const std::filesystem::path& directory,
                         const RestoreOptions& options) {
  return Restoring(snapshot, directory, options).run();
}

}  // namespace weft::storage
