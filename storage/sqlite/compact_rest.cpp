#include <algorithm>

#include "core/network/codec.hpp"
#include "storage/sqlite/compaction.hpp"
#include "storage/sqlite/row_reading.hpp"
#include "storage/sqlite/scan.hpp"

namespace weft::storage::sqlite {
namespace {

constexpr std::size_t kRowsAStep = 2000;
constexpr std::size_t kContentPiece = 100;         // 20 KB each: a few hundred pages
constexpr std::uint64_t kPlacesAPass = 4'000'000;  // 8 bytes each in memory
constexpr int kPagesFreedAStep = 500;

/// Notes older than the floor. Rollbacks stay: later maps may stand on them.
class DeleteRevisions final : public CompactPart {
 public:
  explicit DeleteRevisions(Statement drop) : drop_(std::move(drop)) {}
  Result<bool> step(Compaction& compaction) override {
    const std::uint64_t floor = compaction.retention().floor().value;
    const Database& database = compaction.parts().database;
    const auto first = database.number("SELECT coalesce(min(id), 0) FROM revision WHERE base = id - 1");
    if (!first) return fail(first.error());
    if (*first == 0 || *first >= floor) return false;
    const auto done = compaction.write([&](StoreRow&) -> Result<void> {
      Query query(drop_);
      query << *first << std::min<std::uint64_t>(floor, *first + kRowsAStep);
      if (auto ran = query.run(); !ran) return ran;
      const auto count = database.number("SELECT changes()");
      if (!count) return fail(count.error());
      compaction.deleted.revisions += *count;
      return {};
    });
    if (!done) return fail(done.error());
    return true;
  }
  std::uint64_t done() const override { return 0; }

 private:
  Statement drop_;
};

std::uint64_t prefix_of(const ContentHash& hash) {
  std::uint64_t prefix = 0;
  for (std::size_t at = 0; at < sizeof prefix; ++at) prefix = prefix << 8U | hash.bytes[at];
  return prefix;
}

/// Deletes contents that no place names, found in as many passes over the places as keep the memory bounded: each
/// pass knows the first 8 bytes of the hashes that begin within its range. Two hashes that share them keep each
/// other.
class DeleteContents final : public CompactPart {
 public:
  DeleteContents(const Parts& parts, Statement drop) : parts_(parts), drop_(std::move(drop)) {}

  Result<bool> step(Compaction& compaction) override {
    if (!scan_) {
      if (auto begun = begin(); !begun) return fail(begun.error());
    }
    const Result<bool> more = phase_ == Phase::contents ? sweep(compaction) : collect();
    if (!more || *more) return more;
    scan_.reset();
    switch (phase_) {
      case Phase::places:
        phase_ = Phase::places_anew;
        return true;
      case Phase::places_anew:
        phase_ = Phase::contents;
        std::ranges::sort(used_);
        return true;
      case Phase::contents:
        break;
    }
    phase_ = Phase::places;
    return ++pass_ < passes_ && !is_blind_;
  }
  std::uint64_t done() const override { return done_; }

 private:
  Result<void> begin() {
    if (passes_ == 0) {
      const auto places = parts_.database.number(
          "SELECT (SELECT coalesce(sum(places), 0) FROM experience) + (SELECT count(*) FROM place_anew)");
      if (!places) return fail(places.error());
      passes_ = *places / kPlacesAPass + 1;
    }
    if (phase_ == Phase::places) used_.clear();
    auto scan = scan_of_phase();
    if (!scan) return fail(scan.error());
    scan_ = std::move(*scan);
    return {};
  }

  Result<Scan> scan_of_phase() const {
    const Database& database = parts_.database;
    switch (phase_) {
      case Phase::places:
        return Scan::make(database, "place", {"experience", "place"}, "revision, row");
      case Phase::places_anew:
        return Scan::make(database, "place_anew", {"experience", "place", "revision"}, "row");
      case Phase::contents:
        break;
    }
    return Scan::make(database, "content", {"rowid"}, "hash, kind, size, quarantined");
  }

  bool is_of_pass(std::uint64_t prefix) const { return ((prefix >> 32U) * passes_) >> 32U == pass_; }

  Result<bool> collect() {
    return scan_->next(kRowsAStep, [&](const Query& row) {
      ++done_;
      const Result<Place> place = decode_guarded(row.blob(3), decode_place);
      if (!place) {
        is_blind_ = true;  // it may name any of them
      } else if (const std::uint64_t prefix = prefix_of(place->content.hash); is_of_pass(prefix)) {
        used_.push_back(prefix);
      }
    });
  }

  struct Row {
    std::uint64_t id = 0;
    ContentHash hash;
    std::uint64_t size = 0;
    bool is_quarantined = false;
  };

  Result<bool> sweep(Compaction& compaction) {
    if (is_blind_) return false;
    std::vector<Row> gone;
    const Result<bool> more = scan_->next(kContentPiece, [&](const Query& row) {
      ++done_;
      const Row one{row.number(0), row.id<ContentHash>(1), row.number(3), row.number(4) != 0};
      const std::uint64_t prefix = prefix_of(one.hash);
      const bool is_used = row.number(2) != static_cast<std::uint64_t>(msg::ContentKind::content) ||
                           !is_of_pass(prefix) || std::ranges::binary_search(used_, prefix) ||
                           compaction.used_meanwhile().contains(one.hash);
      if (!is_used) gone.push_back(one);
    });
    if (!more) return fail(more.error());
    if (gone.empty()) return more;
    const auto done = compaction.write([&](StoreRow& store) { return drop(gone, store); });
    if (!done) return fail(done.error());
    compaction.deleted.contents += gone.size();
    for (const Row& row : gone) {
      compaction.deleted.content_bytes += row.size;
      compaction.parts().quarantined.erase(row.hash);
    }
    return more;
  }

  Result<void> drop(const std::vector<Row>& rows, StoreRow& store) {
    for (const Row& row : rows) {
      Query query(drop_);
      query << row.id;
      if (auto done = query.run(); !done) return done;
      if (row.is_quarantined) continue;
      --store.contents;
      store.content_bytes -= row.size;
    }
    return {};
  }

  const Parts& parts_;
  Statement drop_;
  std::optional<Scan> scan_;
  enum class Phase { places, places_anew, contents };
  Phase phase_ = Phase::places;
  bool is_blind_ = false;
  std::uint64_t pass_ = 0;
  std::uint64_t passes_ = 0;
  std::vector<std::uint64_t> used_;
  std::uint64_t done_ = 0;
};

/// Deletes the passes of pieces of which no place is left.
class DeletePasses final : public CompactPart {
 public:
  DeletePasses(Scan scan, Statement places, Statement drop)
      : scan_(std::move(scan)), places_(std::move(places)), drop_(std::move(drop)) {}

  Result<bool> step(Compaction& compaction) override {
    std::vector<RunPiece> pieces;
    const Result<bool> more = scan_.next(kRowsAStep, [&](const Query& row) {
      ++done_;
      pieces.push_back(run_piece(row, 0));
    });
    if (!more) return fail(more.error());
    std::vector<RunPiece> gone;
    for (const RunPiece& piece : pieces) {
      Query query(places_);
      query << piece.experience.value << std::uint64_t{piece.number} * kPlacesOfPiece
            << (std::uint64_t{piece.number} + 1) * kPlacesOfPiece;
      const Result<bool> has_place = query.step();
      if (!has_place) return fail(has_place.error());
      if (!*has_place) gone.push_back(piece);
    }
    if (gone.empty()) return more;
    const auto done = compaction.write([&](StoreRow& /*store*/) { return drop(gone); });
    if (!done) return fail(done.error());
    return more;
  }
  std::uint64_t done() const override { return done_; }

 private:
  Result<void> drop(const std::vector<RunPiece>& pieces) const {
    for (const RunPiece& piece : pieces) {
      Query query(drop_);
      query << piece.experience.value << std::uint64_t{piece.number} << std::uint64_t{piece.is_onward};
      if (auto done = query.run(); !done) return done;
    }
    return {};
  }

  Scan scan_;
  Statement places_;
  Statement drop_;
  std::uint64_t done_ = 0;
};

/// Moves pages from the file's end to its holes and cuts it off there.
class GiveBack final : public CompactPart {
 public:
  Result<bool> step(Compaction& compaction) override {
    const Database& database = compaction.parts().database;
    const auto mode = database.number("PRAGMA auto_vacuum");
    if (!mode) return fail(mode.error());
    const auto free = database.number("PRAGMA freelist_count");
    if (!free) return fail(free.error());
    if (*mode == 2 && *free > 0) {
      if (auto done = database.run("PRAGMA incremental_vacuum(" + std::to_string(kPagesFreedAStep) + ")"); !done) {
        return fail(done.error());
      }
      const auto left = database.number("PRAGMA freelist_count");
      if (!left) return fail(left.error());
      if (*left<*free&& * left> 0) return true;
    }
    if (auto done = database.run("PRAGMA wal_checkpoint(TRUNCATE)"); !done) return fail(done.error());
    return false;
  }
  std::uint64_t done() const override { return 0; }
};

}  // namespace

Result<void> add_rest_compaction(const Parts& parts, CompactParts& to) {
  auto drop_revisions = parts.database.prepare("DELETE FROM revision WHERE id >= ? AND id < ? AND base = id - 1");
  if (!drop_revisions) return fail(drop_revisions.error());
  auto drop_content = parts.database.prepare("DELETE FROM content WHERE rowid = ?");
  if (!drop_content) return fail(drop_content.error());
  auto passes = Scan::make(parts.database, "passes", {"experience", "piece", "onward"}, "length(row)");
  if (!passes) return fail(passes.error());
  auto places =
      parts.database.prepare("SELECT place FROM place WHERE experience = ? AND place >= ? AND place < ? LIMIT 1");
  if (!places) return fail(places.error());
  auto drop_passes = parts.database.prepare("DELETE FROM passes WHERE experience = ? AND piece = ? AND onward = ?");
  if (!drop_passes) return fail(drop_passes.error());
  to.push_back(std::make_unique<DeletePasses>(std::move(*passes), std::move(*places), std::move(*drop_passes)));
  to.push_back(std::make_unique<DeleteRevisions>(std::move(*drop_revisions)));
  to.push_back(std::make_unique<DeleteContents>(parts, std::move(*drop_content)));
  to.push_back(std::make_unique<GiveBack>());
  return {};
}

}  // namespace weft::storage::sqlite
