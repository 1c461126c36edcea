#include <unistd.h>

#include <optional>

#include "storage/sqlite/files.hpp"
#include "storage/sqlite/jobs.hpp"

namespace weft::storage::sqlite {
namespace {

constexpr int kPagesCopiedAStep = 256;
constexpr std::uint64_t kPagesASync = 2048;  // small pieces, so that no step waits for a long write at the end

std::string megabytes(std::uint64_t bytes) {
  return std::to_string((bytes + 500'000) / 1'000'000) + " MB";
}

/// Copies to a name beside the file's; the file is there as a whole, or not at all.
class SnapshotJob final : public StoreJob {
 public:
  SnapshotJob(const Parts& parts, std::filesystem::path file, std::filesystem::path partial,
              std::unique_ptr<Database> copy, Backup backup)
      : parts_(parts),
        file_(std::move(file)),
        partial_(std::move(partial)),
        copy_(std::move(copy)),
        backup_(std::move(backup)) {}
  ~SnapshotJob() override { drop(); }
  SnapshotJob(const SnapshotJob&) = delete;
  SnapshotJob& operator=(const SnapshotJob&) = delete;

  Result<JobProgress> step() override {
    if (failed_) return fail(*failed_);
    if (finished_) return *finished_;
    Result<JobProgress> progress = advance();
    if (!progress) {
      failed_ = progress.error();
      drop();
    } else if (progress->finished) {
      finished_ = *progress;
    }
    return progress;
  }

 private:
  Result<JobProgress> advance() {
    const Result<bool> all = backup_->step(kPagesCopiedAStep);
    if (!all) return fail(all.error().code, "snapshot " + file_.string() + ": " + all.error().message);
    JobProgress progress;
    progress.unit = "pages";
    progress.total = backup_->pages();
    progress.done = progress.total - backup_->remaining();
    if (*all) {
      if (auto done = publish(); !done) return fail(done.error());
      progress.finished = true;
      std::error_code unknown;
      progress.summary = file_.string() + " is a whole store, " +
                         megabytes(std::filesystem::file_size(file_, unknown)) + ", of revision " +
                         std::to_string(parts_.row.revision.value);
    } else if (progress.done < synced_ || progress.done - synced_ >= kPagesASync) {
      if (auto done = sync_file(what(), partial_); !done) return fail(done.error());
      synced_ = progress.done;
    }
    return progress;
  }

  Result<void> publish() {
    backup_.reset();
    copy_.reset();
    if (auto done = sync_file(what(), partial_); !done) return done;
    if (std::error_code ignored; std::filesystem::exists(file_, ignored)) {
      return fail(ErrorCode::conflict, "snapshot " + file_.string() + ": somebody has made a file there meanwhile");
    }
    if (::rename(partial_.c_str(), file_.c_str()) != 0) return fail(file_error(what(), file_, "rename it to"));
    auto done = sync_directory(what(), file_.parent_path());
    if (!done) ::unlink(file_.c_str());
    return done;
  }

  std::string what() const { return "snapshot " + file_.string(); }

  void drop() {
    backup_.reset();
    copy_.reset();
    if (!finished_) ::unlink(partial_.c_str());
  }

  const Parts& parts_;
  std::filesystem::path file_;
  std::filesystem::path partial_;
  std::unique_ptr<Database> copy_;
  std::optional<Backup> backup_;
  std::uint64_t synced_ = 0;
  std::optional<Error> failed_;
  std::optional<JobProgress> finished_;
};

}  // namespace

Result<std::unique_ptr<StoreJob>> make_snapshot(Parts& parts, const std::filesystem::path& file) {
  const std::filesystem::path whole = std::filesystem::absolute(file);
  if (std::error_code ignored; std::filesystem::exists(whole, ignored)) {
    return fail(ErrorCode::conflict, "snapshot " + whole.string() + ": the file exists; name another one");
  }
  std::filesystem::path partial = whole;
  partial += ".part";
  ::unlink(partial.c_str());  // of a process that was killed
  if (auto made = make_file("snapshot " + whole.string(), partial); !made) return fail(made.error());
  auto copy = Database::open(partial, parts.vfs);
  if (!copy) {
    ::unlink(partial.c_str());
    return fail(copy.error().code, "snapshot " + whole.string() + ": " + copy.error().message);
  }
  // It counts only once it is whole and synchronised, so neither a journal nor SQLite's own syncs are needed.
  if (auto done = copy->run("PRAGMA journal_mode = OFF; PRAGMA synchronous = OFF; PRAGMA cache_size = -2048");
      !done) {
    ::unlink(partial.c_str());
    return fail(done.error());
  }
  auto owned = std::make_unique<Database>(std::move(*copy));
  auto backup = Backup::begin(*owned, parts.database);
  if (!backup) {
    ::unlink(partial.c_str());
    return fail(backup.error());
  }
  return std::make_unique<SnapshotJob>(parts, whole, partial, std::move(owned), std::move(*backup));
}

}  // namespace weft::storage::sqlite
