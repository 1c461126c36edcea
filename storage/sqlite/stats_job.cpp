#include <array>
#include <optional>

#include "core/protocol/messages.hpp"
#include "storage/sqlite/jobs.hpp"
#include "storage/sqlite/scan.hpp"

namespace weft::storage::sqlite {
namespace {

constexpr std::size_t kCountedAStep = 2000;

/// Describes a table that is counted, and what its rows take; SQL over the row's columns.
struct Table {
  const char* name;
  const char* kind;
  std::vector<std::string> keys;
  const char* bytes;
};

std::vector<Table> tables() {
  const std::vector<std::string> stitch{"revision", "a_experience", "a_place", "b_experience", "b_place", "is_back"};
  const std::vector<std::string> apart{"one_experience", "one_first",  "one_last", "other_experience",
                                       "other_first",    "other_last", "revision"};
  return {
      {"place", "places", {"experience", "place"}, "length(row) + 16"},
      {"place_anew", "places", {"experience", "place", "revision"}, "length(row) + 24"},
      {"edge", "edges", {"a_experience", "a_place", "b_experience", "b_place", "revision"}, "length(row) + 32"},
      {"experience", "experiences", {"id"}, "length(name) + length(method) + length(seal_reason) + 48"},
      {"batch", "batches", {"experience", "sequence"}, "52"},
      {"revision", "history", {"id"}, "length(kind) + length(who) + length(cause) + 24"},
      {"label", "history", {"label", "revision"}, "length(label) + 24"},
      {"apart", "history", apart, "64"},
      {"rule", "history", {"name", "revision"}, "length(name) + length(row) + 16"},
      {"registration", "history", {"plan", "revision"}, "length(plan) + length(row) + 16"},
      {"moved_places", "history", {"revision", "experience", "first_place", "is_back"}, "32"},
      {"moved_stitch", "history", stitch, "40"},
      {"deleted_places", "history", {"experience", "first_place"}, "20"},
      {"event", "events", {"id"}, "length(kind) + length(cause) + length(who) + 48"},
      {"goal", "goals", {"id"}, "length(row) + 20"},
      {"route", "goals", {"goal"}, "length(row) + 20"},
      {"occupancy", "goals", {"robot"}, "length(row) + 24"},
      {"robot", "goals", {"id"}, "length(name) + 20"},
      {"hold", "goals", {"robot"}, "length(who) + 20"},
      {"awaited_label", "goals", {"label"}, "length(label) + length(who) + 60"},
      {"passes", "passes", {"experience", "piece", "onward"}, "length(row) + 16"},
      {"preparation", "preparations", {"methods"}, "length(bytes) + 64"},
  };
}

/// Adds up the rows of one table after another. What pages hold beyond their rows is the file's size less all of it.
class StatsJob final : public StoreJob {
 public:
  explicit StatsJob(const Parts& parts) : parts_(parts), tables_(tables()) {}

  Result<JobProgress> step() override {
    if (failed_) return fail(*failed_);
    auto more = at_ <= tables_.size() ? advance() : Result<bool>(false);
    if (!more) {
      failed_ = more.error();
      return fail(*failed_);
    }
    JobProgress progress;
    progress.unit = "rows";
    progress.done = done_;
    progress.finished = at_ > tables_.size();
    progress.total = progress.finished ? done_ : std::max(done_, estimate());
    if (progress.finished) {
      if (auto done = finish(progress); !done) return fail(done.error());
    }
    return progress;
  }

 private:
  /// Counts a piece of a table. The contents come last: table number tables_.size().
  Result<bool> advance() {
    const bool is_content = at_ == tables_.size();
    if (!scan_) {
      auto scan = is_content ? Scan::make(parts_.database, "content", {"rowid"}, "length(bytes), size, kind")
                             : Scan::make(parts_.database, tables_[at_].name, tables_[at_].keys, tables_[at_].bytes);
      if (!scan) return fail(scan.error());
      scan_ = std::move(*scan);
    }
    const auto column = static_cast<int>(is_content ? 1 : tables_[at_].keys.size());
    const Result<bool> more = scan_->next(kCountedAStep, [&](const Query& row) {
      ++done_;
      const bool is_cloud = is_content && row.number(3) == static_cast<std::uint64_t>(msg::ContentKind::cloud);
      SpaceUse& use = of(is_cloud ? "clouds" : is_content ? "contents" : tables_[at_].kind);
      ++use.count;
      use.disk_bytes += row.number(column) + (is_content ? 48 : 0);
      use.uncompressed_bytes += row.number(is_content ? 2 : column);
    });
    if (!more) return fail(more.error());
    if (!*more) {
      scan_.reset();
      ++at_;
    }
    return true;
  }

  SpaceUse& of(const std::string& kind) {
    for (SpaceUse& use : space_) {
      if (use.kind == kind) return use;
    }
    return space_.emplace_back(SpaceUse{kind, 0, 0, 0});
  }

  Result<void> finish(JobProgress& progress) const {
    const auto pages = parts_.database.number("PRAGMA page_count");
    const auto free = parts_.database.number("PRAGMA freelist_count");
    const auto page = parts_.database.number("PRAGMA page_size");
    for (const auto* number : {&pages, &free, &page}) {
      if (!*number) return fail(number->error());
    }
    progress.space = space_;
    std::uint64_t rows = *free * *page;
    for (const SpaceUse& use : space_) rows += use.disk_bytes;
    const std::uint64_t file = *pages * *page;
    const std::uint64_t rest = file > rows ? file - rows : 0;
    progress.space.push_back({"indexes and page ends", 0, rest, rest});
    progress.space.push_back({"free pages", *free, *free * *page, *free * *page});
    std::error_code unknown;
    const auto log = std::filesystem::file_size(parts_.directory / "map.sqlite-wal", unknown);
    const std::uint64_t log_bytes = unknown ? 0 : log;
    progress.space.push_back({"write-ahead log", 0, log_bytes, log_bytes});
    progress.summary = std::to_string((file + log_bytes) / 1'000'000) + " MB on disk, " +
                       std::to_string(*free * *page / 1'000'000) + " MB of them free";
    return {};
  }

  std::uint64_t estimate() const {
    return parts_.database
        .number(
            "SELECT (SELECT contents + revision - floor FROM store) +"
            " (SELECT coalesce(sum(2 * places + durable_through + 1), 0) FROM experience)")
        .value_or(0);
  }

  const Parts& parts_;
  std::vector<Table> tables_;
  std::size_t at_ = 0;
  std::optional<Scan> scan_;
  std::vector<SpaceUse> space_;
  std::uint64_t done_ = 0;
  std::optional<Error> failed_;
};

}  // namespace

Result<std::unique_ptr<StoreJob>> make_stats(const Parts& parts) {
  return std::make_unique<StatsJob>(parts);
}

}  // namespace weft::storage::sqlite
