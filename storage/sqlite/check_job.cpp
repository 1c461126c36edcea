#include <numeric>

#include "storage/sqlite/check_parts.hpp"
#include "storage/sqlite/jobs.hpp"

namespace weft::storage::sqlite {
namespace {

constexpr std::uint64_t kStepsAnEstimate = 200;

class CheckJob final : public StoreJob {
 public:
  CheckJob(Parts& parts, CheckParts tables) : parts_(parts), tables_(std::move(tables)) {}

  Result<JobProgress> step() override {
    if (failed_) return fail(*failed_);
    JobProgress progress;
    if (at_ < tables_.size()) {
      const Result<bool> more = tables_[at_]->step(progress.findings);
      if (!more) {
        failed_ = more.error();
        return fail(*failed_);
      }
      found_ += progress.findings.size();
      at_ += *more ? 0 : 1;
    }
    progress.done = std::accumulate(tables_.begin(), tables_.end(), std::uint64_t{0},
                                    [](std::uint64_t sum, const auto& table) { return sum + table->done(); });
    progress.unit = "rows";
    progress.finished = at_ == tables_.size();
    if (steps_++ % kStepsAnEstimate == 0) expected_ = estimate().value_or(0);
    progress.total = progress.finished ? progress.done : std::max(progress.done, expected_);
    if (progress.finished) progress.summary = summary(progress.done);
    return progress;
  }

 private:
  /// Estimates how many rows will be read. Places count twice: for their rows, and for the edges that start there.
  Result<std::uint64_t> estimate() const {
    return parts_.database.number(
        "SELECT (SELECT contents + revision - floor FROM store) +"
        " (SELECT coalesce(sum(2 * places + durable_through + 1), 0) FROM experience)");
  }

  std::string summary(std::uint64_t rows) const {
    const std::string read = std::to_string(rows) + " rows read, ";
    if (found_ == 0) return read + "nothing is damaged";
    return read + std::to_string(found_) + " found damaged; the rest is served. To get them back restore a snapshot";
  }

  Parts& parts_;
  CheckParts tables_;
  std::size_t at_ = 0;
  std::uint64_t found_ = 0;
  std::uint64_t steps_ = 0;
  std::uint64_t expected_ = 0;
  std::optional<Error> failed_;
};

}  // namespace

Result<std::unique_ptr<StoreJob>> make_check(Parts& parts) {
  CheckParts tables;
  for (const auto add : {+[](Parts&of, CheckParts&to) { return add_record_checks(of, to); },
                         +[](Parts&of, CheckParts&to) { return add_map_checks(of, to); },
                         +[](Parts&of, CheckParts&to) { return add_content_checks(of, to); }}) {
    if (auto done = add(parts, tables); !done) return fail(done.error());
  }
  return std::make_unique<CheckJob>(parts, std::move(tables));
}

}  // namespace weft::storage::sqlite
