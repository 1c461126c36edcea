#include <functional>
#include <limits>
#include <optional>

#include "core/network/codec.hpp"
#include "storage/sqlite/check_parts.hpp"
#include "storage/sqlite/lookup.hpp"
#include "storage/sqlite/row_reading.hpp"
#include "storage/sqlite/scan.hpp"

namespace weft::storage::sqlite {
namespace {

constexpr std::size_t kRecordPiece = 500;

/// Checks that each experience has as many places and batches as it says: checks by row see gaps, not a missing end.
class ExperienceCheck final : public CheckPart {
 public:
  ExperienceCheck(Scan scan, Lookup lookup) : scan_(std::move(scan)), lookup_(std::move(lookup)) {}

  Result<bool> step(Findings& findings) override {
    lookup_.forget();
    std::vector<Row> rows;
    const Result<bool> more = scan_.next(kRecordPiece, [&](const Query& row) {
      rows.push_back({{row.number(0)}, row.number(1), row.number(2)});
    });
    if (!more) return fail(more.error());
    for (const Row& row : rows) {
      ++done_;
      if (auto done = look(row, findings); !done) return fail(done.error());
    }
    return more;
  }
  std::uint64_t done() const override { return done_; }

 private:
  struct Row {
    ExperienceId id;
    std::uint64_t places = 0;
    std::uint64_t durable_through = 0;
  };

  Result<void> look(const Row& row, Findings& findings) {
    const std::string name = "experience " + to_string(row.id);
    const Result<std::uint64_t> next = next_place(row.id);
    if (!next) return fail(next.error());
    if (*next < row.places) {
      findings.push_back(name + ": it says " + std::to_string(row.places) + " places, the rows from " +
                         std::to_string(*next) + " on are missing");
    } else if (*next > row.places) {
      findings.push_back(name + ": it says " + std::to_string(row.places) + " places, there are rows up to " +
                         std::to_string(*next - 1));
    }
    const Result<std::uint64_t> last = lookup_.last_batch(row.id);
    if (!last) return fail(last.error());
    if (*last != row.durable_through) {
      findings.push_back(name + ": it says that it is durable through batch " + std::to_string(row.durable_through) +
                         ", the last one there is " + std::to_string(*last));
    }
    return {};
  }

  Result<std::uint64_t> next_place(ExperienceId id) {
    const auto last = lookup_.last_place(id);
    if (!last) return fail(last.error());
    const auto deleted = lookup_.deleted_of(id);
    if (!deleted) return fail(deleted.error());
    std::uint64_t next = *last ? **last + 1 : 0;
    for (const Stretch& stretch : **deleted) {
      if (stretch.first <= next) next = std::max<std::uint64_t>(next, std::uint64_t{stretch.last} + 1);
    }
    return next;
  }

  Scan scan_;
  Lookup lookup_;
  std::uint64_t done_ = 0;
};

/// Calls a function a row that needs no lookups.
class RowCheck final : public CheckPart {
 public:
  using Look = std::function<void(const Query&, Findings&)>;
  RowCheck(Scan scan, Look look) : scan_(std::move(scan)), look_(std::move(look)) {}
  Result<bool> step(Findings& findings) override {
    return scan_.next(kRecordPiece, [&](const Query& row) {
      ++done_;
      look_(row, findings);
    });
  }
  std::uint64_t done() const override { return done_; }

 private:
  Scan scan_;
  Look look_;
  std::uint64_t done_ = 0;
};

/// Returns a look at batches: sequences from 1 without a gap within each experience.
RowCheck::Look look_at_batches(const Parts& parts) {
  return [&parts, last = std::pair<std::uint64_t, std::uint64_t>()](const Query& row, Findings& findings) mutable {
    const std::uint64_t experience = row.number(0);
    const std::uint64_t sequence = row.number(1);
    const std::string name =
        "batch " + std::to_string(sequence) + " of experience " + to_string(ExperienceId{experience});
    const std::uint64_t expected = last.first == experience ? last.second + 1 : 1;
    if (sequence != expected) {
      findings.push_back(name + ": the one before it has no row, " + std::to_string(expected) + " was expected");
    }
    last = {experience, sequence};
    if (row.number(2) < 1 || row.number(2) > parts.row.revision.value) {
      findings.push_back(name + ": it says revision " + std::to_string(row.number(2)) + ", the newest is " +
                         std::to_string(parts.row.revision.value));
    }
    if (row.blob(3).size() != sizeof(ContentHash::bytes)) findings.push_back(name + ": its hash is damaged");
  };
}

/// Looks for gaps from the oldest revision that is kept; older rows are there for rollbacks only.
RowCheck::Look look_at_revisions(const Parts& parts) {
  return [&parts, last = std::optional<std::uint64_t>()](const Query& row, Findings& findings) mutable {
    const std::uint64_t id = row.number(0);
    const std::string name = "revision " + std::to_string(id);
    if (row.number(1) >= id) findings.push_back(name + ": it stands on " + std::to_string(row.number(1)));
    const std::uint64_t oldest = std::max<std::uint64_t>(parts.row.floor.value, 1);
    if (id < oldest) return;
    const std::uint64_t expected = last ? *last + 1 : oldest;
    if (id > expected) findings.push_back("revision " + std::to_string(expected) + ": the row is missing");
    if (id > parts.row.revision.value) {
      findings.push_back(name + ": the store's newest is " + std::to_string(parts.row.revision.value));
    }
    last = id;
  };
}

/// Checks the last revisions; a gap at the end is not seen by a look at rows.
class NewestCheck final : public CheckPart {
 public:
  explicit NewestCheck(const Parts& parts) : parts_(parts) {}
  Result<bool> step(Findings& findings) override {
    const auto last = parts_.database.number("SELECT coalesce(max(id), 0) FROM revision");
    if (!last) return fail(last.error());
    if (*last < parts_.row.revision.value) {
      findings.push_back("revision " + std::to_string(*last + 1) + " to " +
                         std::to_string(parts_.row.revision.value) + ": the rows are missing");
    }
    return false;
  }
  std::uint64_t done() const override { return 0; }

 private:
  const Parts& parts_;
};

template <class Id, class Decode>
RowCheck::Look look_at_rows(std::string table, Decode decode) {
  return [table = std::move(table), decode](const Query& row, Findings& findings) {
    const auto value = decode_guarded(row.blob(1), decode);
    if (!value) findings.push_back(table + " " + to_string(row.id<Id>(0)) + ": " + value.error().message);
  };
}

void look_at_passes(const Query& row, Findings& findings) {
  const auto passes = decode_guarded(row.blob(3), decode_passes);
  if (!passes) findings.push_back(passes_of(run_piece(row, 0)) + ": " + passes.error().message);
}

void look_at_awaited_label(const Query& row, Findings& findings) {
  const auto label = awaited_label(row);
  if (!label) findings.push_back("awaited_label " + row.text(0) + ": " + label.error().message);
}

Result<void> add(const Parts& parts, CheckParts& to, const char* table, const std::vector<std::string>& keys,
                 const char* columns, RowCheck::Look look) {
  auto scan = Scan::make(parts.database, table, keys, columns);
  if (!scan) return fail(scan.error());
  to.push_back(std::make_unique<RowCheck>(std::move(*scan), std::move(look)));
  return {};
}

Result<void> add_experiences(const Parts& parts, CheckParts& to) {
  auto scan = Scan::make(parts.database, "experience", {"id"}, "places, durable_through");
  if (!scan) return fail(scan.error());
  auto lookup = Lookup::make(parts.database);
  if (!lookup) return fail(lookup.error());
  to.push_back(std::make_unique<ExperienceCheck>(std::move(*scan), std::move(*lookup)));
  return {};
}

}  // namespace

Result<void> add_record_checks(const Parts& parts, CheckParts& to) {
  to.push_back(std::make_unique<NewestCheck>(parts));
  Result<void> done = add(parts, to, "revision", {"id"}, "base", look_at_revisions(parts));
  if (done) done = add_experiences(parts, to);
  if (done) {
    done = add(parts, to, "batch", {"experience", "sequence"}, "revision, hash", look_at_batches(parts));
  }
  if (done) done = add(parts, to, "goal", {"id"}, "row", look_at_rows<GoalId>("goal", decode_goal));
  if (done) done = add(parts, to, "route", {"goal"}, "row", look_at_rows<GoalId>("route", decode_route));
  if (done) done = add(parts, to, "occupancy", {"robot"}, "row", look_at_rows<RobotId>("occupancy", decode_route));
  if (done) {
    done = add(parts, to, "awaited_label", {"label"}, kAwaitedLabelColumns, look_at_awaited_label);
  }
  if (done) done = add(parts, to, "passes", {"experience", "piece", "onward"}, "row", look_at_passes);
  return done;
}

}  // namespace weft::storage::sqlite
