#include <numeric>

#include "storage/sqlite/compaction.hpp"
#include "storage/sqlite/jobs.hpp"

namespace weft::storage::sqlite {
namespace {

constexpr std::uint64_t kStepsBetweenEstimates = 200;

class CompactJob final : public StoreJob {
 public:
  CompactJob(std::unique_ptr<Compaction> compaction, CompactParts pieces)
      : compaction_(std::move(compaction)), pieces_(std::move(pieces)) {}

  Result<JobProgress> step() override {
    if (failed_) return fail(*failed_);
    if (at_ < pieces_.size()) {
      const Result<bool> more = pieces_[at_]->step(*compaction_);
      if (!more) {
        failed_ = Error{more.error().code, "compaction before revision " +
                                               std::to_string(compaction_->retention().floor().value) + ": " +
                                               more.error().message + "; ask for it again, it goes on"};
        return fail(*failed_);
      }
      at_ += *more ? 0 : 1;
    }
    if (steps_++ % kStepsBetweenEstimates == 0) expected_ = estimate();
    JobProgress progress;
    progress.unit = "rows";
    progress.done = std::accumulate(pieces_.begin(), pieces_.end(), std::uint64_t{0},
                                    [](std::uint64_t sum, const auto& piece) { return sum + piece->done(); });
    progress.finished = at_ == pieces_.size();
    progress.total = progress.finished ? progress.done : std::max(progress.done, expected_);
    if (progress.finished) progress.summary = summary();
    return progress;
  }

 private:
  /// Estimates the rows to be looked at: places twice, for themselves and their contents, and about as many edges.
  std::uint64_t estimate() const {
    return compaction_->parts()
        .database
        .number("SELECT (SELECT contents FROM store) + (SELECT coalesce(sum(3 * places), 0) FROM experience)")
        .value_or(0);
  }

  std::string summary() const {
    const Compaction::Deleted& gone = compaction_->deleted;
    const Database& database = compaction_->parts().database;
    const std::uint64_t free_bytes =
        database.number("PRAGMA freelist_count").value_or(0) * database.number("PRAGMA page_size").value_or(0);
    std::string text = "revision " + std::to_string(compaction_->retention().floor().value) +
                       " is the oldest that is kept; deleted " + std::to_string(gone.places) + " places, " +
                       std::to_string(gone.edges) + " edges, " + std::to_string(gone.labels) +
                       " meanings of labels, " + std::to_string(gone.contents) + " contents of " +
                       std::to_string(gone.content_bytes / 1'000'000) + " MB";
    if (free_bytes > 0) {
      text += "; " + std::to_string(free_bytes / 1'000'000) +
              " MB of the file are free for what comes (a file of an older schema shrinks when a snapshot of it is "
              "restored)";
    }
    return text;
  }

  std::unique_ptr<Compaction> compaction_;
  CompactParts pieces_;
  std::size_t at_ = 0;
  std::uint64_t steps_ = 0;
  std::uint64_t expected_ = 0;
  std::optional<Error> failed_;
};

Result<void> check_floor(const Parts& parts, Revision before) {
  if (before > parts.row.revision || before.value == 0) {
    return fail(ErrorCode::not_found, "compaction: the map has no revision " + std::to_string(before.value) +
                                          " to keep; its newest is " + std::to_string(parts.row.revision.value));
  }
  if (auto kept = check_kept("compaction", before, parts.row.floor); !kept) return kept;
  if (!parts.used_meanwhile.expired()) {
    return fail(ErrorCode::unavailable, "compaction: another one is under way; wait for its end");
  }
  return {};
}

}  // namespace

Result<std::unique_ptr<StoreJob>> make_compaction(Parts& parts, Revision before) {
  if (auto fits = check_floor(parts, before); !fits) return fail(fits.error());
  auto compaction = Compaction::make(parts, before);
  if (!compaction) return fail(compaction.error());
  CompactParts pieces;
  if (auto added = add_map_compaction(parts, pieces); !added) return fail(added.error());
  if (auto added = add_rest_compaction(parts, pieces); !added) return fail(added.error());
  // First of all, so that nothing goes back to what is about to go.
  const auto floored = (*compaction)->write([&](StoreRow& row) -> Result<void> {
    row.floor = before;
    return {};
  });
  if (!floored) return fail(floored.error());
  return std::make_unique<CompactJob>(std::move(*compaction), std::move(pieces));
}

}  // namespace weft::storage::sqlite
