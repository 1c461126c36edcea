#include <optional>

#include "core/network/index_of.hpp"
#include "storage/sqlite/compaction.hpp"
#include "storage/sqlite/lookup.hpp"
#include "storage/sqlite/row_reading.hpp"
#include "storage/sqlite/scan.hpp"

namespace weft::storage::sqlite {
namespace {

constexpr std::size_t kMarkPiece = 2000;

template <class... Bound>
Result<std::uint64_t> run(const Database& database, const Statement& statement, const Bound&... bound) {
  Query query(statement);
  (static_cast<void>(query << bound), ...);
  if (auto done = query.run(); !done) return fail(done.error());
  return database.number("SELECT changes()");
}

/// Says of each place whether it goes: from then on it is in no map, whether its rows are still there or not.
class MarkPlaces final : public CompactPart {
 public:
  MarkPlaces(Scan scan, Lookup lookup, Statement clear, Statement put)
      : scan_(std::move(scan)), lookup_(std::move(lookup)), clear_(std::move(clear)), put_(std::move(put)) {}

  Result<bool> step(Compaction& compaction) override {
    lookup_.forget();
    std::vector<std::pair<PlaceId, std::uint64_t>> rows;
    const Result<bool> more =
        scan_.next(kMarkPiece, [&](const Query& row) { rows.emplace_back(place_id(row, 0), row.number(2)); });
    if (!more) return fail(more.error());
    done_ += rows.size();
    std::map<ExperienceId, std::vector<Stretch>> marks;
    for (const auto& [id, revision] : rows) {
      const auto places = compaction.places_of(id.experience);
      if (!places) return fail(places.error());
      if ((*places)->keeps(id.index, revision)) continue;
      const Result<bool> is_marked = lookup_.is_deleted(id);
      if (!is_marked) return fail(is_marked.error());
      if (!*is_marked) marks[id.experience].push_back({id.experience, id.index, id.index});
    }
    if (!marks.empty()) {
      if (auto done = compaction.write([&](StoreRow&) { return mark(marks); }); !done) return fail(done.error());
    }
    return more;
  }
  std::uint64_t done() const override { return done_; }

 private:
  Result<void> mark(const std::map<ExperienceId, std::vector<Stretch>>& marks) {
    for (const auto& [id, fresh] : marks) {
      const auto known = lookup_.deleted_of(id);
      if (!known) return fail(known.error());
      std::vector<Stretch> all = **known;
      all.insert(all.end(), fresh.begin(), fresh.end());
      Query clear(clear_);
      if (auto done = (clear << id.value).run(); !done) return done;
      for (const Stretch& stretch : joined(std::move(all))) {
        Query put(put_);
        put << id.value << std::uint64_t{stretch.first} << std::uint64_t{stretch.last};
        if (auto done = put.run(); !done) return done;
      }
    }
    return {};
  }

  Scan scan_;
  Lookup lookup_;
  Statement clear_;
  Statement put_;
  std::uint64_t done_ = 0;
};

/// Deletes edges of marked places, and stitches taken out or replaced. From the newest row of a pair to the oldest.
class DeleteEdges final : public CompactPart {
 public:
  DeleteEdges(Scan scan, Lookup lookup, Statement drop)
      : scan_(std::move(scan)), lookup_(std::move(lookup)), drop_(std::move(drop)) {}

  Result<bool> step(Compaction& compaction) override {
    lookup_.forget();
    std::vector<std::pair<EdgeId, std::uint64_t>> rows;
    const Result<bool> more = scan_.next(kMarkPiece, [&](const Query& row) {
      rows.emplace_back(EdgeId{place_id(row, 0), place_id(row, 2)}, row.number(4));
    });
    if (!more) return fail(more.error());
    done_ += rows.size();
    std::vector<std::pair<EdgeId, std::uint64_t>> gone;
    for (const auto& row : rows) {
      const Result<bool> kept = keeps(compaction, row.first, row.second);
      if (!kept) return fail(kept.error());
      if (!*kept) gone.push_back(row);
    }
    if (!gone.empty()) {
      if (auto done = compaction.write([&](StoreRow&) { return drop(gone); }); !done) return fail(done.error());
      compaction.deleted.edges += gone.size();
    }
    return more;
  }
  std::uint64_t done() const override { return done_; }

 private:
  Result<bool> keeps(Compaction& compaction, const EdgeId& id, std::uint64_t revision) {
    if (pair_ != id) {
      pair_ = id;
      rows_.emplace(compaction.retention());
    }
    const auto moves = compaction.moves_of(id);
    if (!moves) return fail(moves.error());
    const bool is_latest = rows_->keeps(revision, **moves);  // asked of every row: it counts them
    if (!is_latest && !is_hop(id)) return false;             // a hop stays as long as its places
    for (const PlaceId& end : {id.a, id.b}) {
      const Result<bool> deleted = lookup_.is_deleted(end);
      if (!deleted) return fail(deleted.error());
      if (*deleted) return false;
    }
    return true;
  }

  Result<void> drop(const std::vector<std::pair<EdgeId, std::uint64_t>>& rows) {
    for (const auto& [id, revision] : rows) {
      Query query(drop_);
      query << id.a.experience.value << std::uint64_t{id.a.index} << id.b.experience.value
            << std::uint64_t{id.b.index} << revision;
      if (auto done = query.run(); !done) return done;
    }
    return {};
  }

  Scan scan_;
  Lookup lookup_;
  Statement drop_;
  std::optional<EdgeId> pair_;
  std::optional<LatestRetention> rows_;
  std::uint64_t done_ = 0;
};

/// Deletes the rows of marked places.
class DeletePlaces final : public CompactPart {
 public:
  DeletePlaces(Scan scan, Statement drop) : scan_(std::move(scan)), drop_(std::move(drop)) {}

  Result<bool> step(Compaction& compaction) override {
    if (!now_) {
      const Result<bool> more = scan_.next(1, [&](const Query& row) {
        const PlaceId first = place_id(row, 0);
        now_ = Stretch{first.experience, first.index, static_cast<std::uint32_t>(row.number(2))};
      });
      if (!more) return fail(more.error());
      if (!now_) return false;
    }
    const std::uint64_t last = std::min<std::uint64_t>(now_->last, std::uint64_t{now_->first} + kMarkPiece);
    const auto done = compaction.write([&](StoreRow&) -> Result<void> {
      const auto count =
          run(compaction.parts().database, drop_, now_->experience.value, std::uint64_t{now_->first}, last);
      if (!count) return fail(count.error());
      compaction.deleted.places += *count;
      return {};
    });
    if (!done) return fail(done.error());
    if (last == now_->last) {
      now_.reset();
    } else {
      now_->first = static_cast<std::uint32_t>(last + 1);
    }
    return true;
  }
  std::uint64_t done() const override { return 0; }

 private:
  Scan scan_;
  Statement drop_;
  std::optional<Stretch> now_;
};

/// Deletes versions of places between the first and the last that no kept map has. From the newest row of a place to
/// the oldest.
class DeletePlacesAnew final : public CompactPart {
 public:
  DeletePlacesAnew(Scan scan, Lookup lookup, Statement drop)
      : scan_(std::move(scan)), lookup_(std::move(lookup)), drop_(std::move(drop)) {}

  Result<bool> step(Compaction& compaction) override {
    lookup_.forget();
    std::vector<std::pair<PlaceId, std::uint64_t>> rows;
    const Result<bool> more =
        scan_.next(kMarkPiece, [&](const Query& row) { rows.emplace_back(place_id(row, 0), row.number(2)); });
    if (!more) return fail(more.error());
    done_ += rows.size();
    std::vector<std::pair<PlaceId, std::uint64_t>> gone;
    for (const auto& row : rows) {
      if (place_ != row.first) {
        place_ = row.first;
        rows_.emplace(compaction.retention());
      }
      const bool is_latest = rows_->keeps(row.second);  // asked of every row: it counts them
      const Result<bool> deleted = lookup_.is_deleted(row.first);
      if (!deleted) return fail(deleted.error());
      if (!is_latest || *deleted) gone.push_back(row);
    }
    if (gone.empty()) return more;
    const auto done = compaction.write([&](StoreRow&) -> Result<void> {
      for (const auto& [id, revision] : gone) {
        Query query(drop_);
        query << id.experience.value << std::uint64_t{id.index} << revision;
        if (auto ran = query.run(); !ran) return ran;
      }
      return {};
    });
    if (!done) return fail(done.error());
    return more;
  }
  std::uint64_t done() const override { return done_; }

 private:
  Scan scan_;
  Lookup lookup_;
  Statement drop_;
  std::optional<PlaceId> place_;
  std::optional<LatestRetention> rows_;
  std::uint64_t done_ = 0;
};

/// Deletes meanings of a label, or rules and registrations of a name, that have been replaced by a later one in every
/// kept map. From the newest to the oldest.
class DeleteNamed final : public CompactPart {
 public:
  enum class What : std::uint8_t { labels, rules, registrations };
  DeleteNamed(What what, Scan scan, Statement drop) : what_(what), scan_(std::move(scan)), drop_(std::move(drop)) {}

  Result<bool> step(Compaction& compaction) override {
    std::vector<std::pair<std::string, std::uint64_t>> gone;
    const Result<bool> more = scan_.next(kMarkPiece, [&](const Query& row) {
      ++done_;
      if (!rows_ || name_ != row.text(0)) {
        name_ = row.text(0);
        rows_.emplace(compaction.retention());
      }
      if (!rows_->keeps(row.number(1))) gone.emplace_back(name_, row.number(1));
    });
    if (!more) return fail(more.error());
    if (gone.empty()) return more;
    const auto done = compaction.write([&](StoreRow&) -> Result<void> {
      for (const auto& [name, revision] : gone) {
        const auto count = run(compaction.parts().database, drop_, std::string_view(name), revision);
        if (!count) return fail(count.error());
        if (what_ == What::labels) compaction.deleted.labels += *count;
      }
      return {};
    });
    if (!done) return fail(done.error());
    return more;
  }
  std::uint64_t done() const override { return done_; }

 private:
  What what_;
  Scan scan_;
  Statement drop_;
  std::string name_;
  std::optional<LatestRetention> rows_;
  std::uint64_t done_ = 0;
};

/// Deletes operators' words on what is apart that a later word has replaced in every kept map, and words on stretches
/// that are not stored any more. From the newest word to the oldest. Few: all in one piece.
class DeleteAparts final : public CompactPart {
 public:
  explicit DeleteAparts(Statement drop) : drop_(std::move(drop)) {}

  Result<bool> step(Compaction& compaction) override {
    const Database& database = compaction.parts().database;
    std::map<Apart, LatestRetention> latest;
    std::vector<std::pair<Apart, std::uint64_t>> gone;
    auto lookup = Lookup::make(database);
    if (!lookup) return fail(lookup.error());
    std::vector<std::pair<Apart, std::uint64_t>> rows;
    auto done = for_each_row(database,
                             std::string("SELECT ") + kApartColumns + ", revision FROM apart ORDER BY revision DESC",
                             [&](const Query& row) { rows.emplace_back(apart(row), row.number(6)); });
    if (!done) return fail(done.error());
    done_ = rows.size();
    for (const auto& row : rows) {
      const bool is_latest = latest.try_emplace(row.first, compaction.retention()).first->second.keeps(row.second);
      const Result<bool> deleted = is_deleted(row.first, *lookup);
      if (!deleted) return fail(deleted.error());
      if (!is_latest || *deleted) gone.push_back(row);
    }
    if (gone.empty()) return false;
    done = compaction.write([&](StoreRow&) { return drop(gone); });
    if (!done) return fail(done.error());
    return false;
  }
  std::uint64_t done() const override { return done_; }

 private:
  static Result<bool> is_deleted(const Apart& apart, Lookup& lookup) {
    for (const Stretch& stretch : {apart.one, apart.other}) {
      const auto deleted = lookup.deleted_of(stretch.experience);
      if (!deleted) return fail(deleted.error());
      for (const Stretch& part : **deleted) {
        if (part.first <= stretch.first && stretch.last <= part.last) return true;
      }
    }
    return false;
  }
  Result<void> drop(const std::vector<std::pair<Apart, std::uint64_t>>& rows) {
    for (const auto& [apart, revision] : rows) {
      Query query(drop_);
      for (const Stretch& stretch : {apart.one, apart.other}) {
        query << stretch.experience.value << std::uint64_t{stretch.first} << std::uint64_t{stretch.last};
      }
      query << revision;
      if (auto done = query.run(); !done) return done;
    }
    return {};
  }

  Statement drop_;
  std::uint64_t done_ = 0;
};

/// Moves up to the floor of what is not stored any more.
class DeleteMoves final : public CompactPart {
 public:
  DeleteMoves(Statement places, Statement stitches) : places_(std::move(places)), stitches_(std::move(stitches)) {}

  Result<bool> step(Compaction& compaction) override {
    const std::uint64_t floor = compaction.retention().floor().value;
    const auto done = compaction.write([&](StoreRow&) -> Result<void> {
      if (auto count = run(compaction.parts().database, places_, floor); !count) return fail(count.error());
      if (auto count = run(compaction.parts().database, stitches_, floor); !count) return fail(count.error());
      return {};
    });
    if (!done) return fail(done.error());
    ++compaction.parts().moves;
    return false;
  }
  std::uint64_t done() const override { return 0; }

 private:
  Statement places_;
  Statement stitches_;
};

constexpr const char* kDropMovedPlaces =
    "DELETE FROM moved_places WHERE revision <= ? AND EXISTS (SELECT 1 FROM deleted_places AS gone"
    " WHERE gone.experience = moved_places.experience AND gone.first_place <= moved_places.first_place"
    " AND gone.last_place >= moved_places.last_place)";
constexpr const char* kDropMovedStitches =
    "DELETE FROM moved_stitch WHERE revision <= ? AND NOT EXISTS (SELECT 1 FROM edge"
    " WHERE edge.a_experience = moved_stitch.a_experience AND edge.a_place = moved_stitch.a_place"
    " AND edge.b_experience = moved_stitch.b_experience AND edge.b_place = moved_stitch.b_place)";

}  // namespace

Result<void> add_map_compaction(const Parts& parts, CompactParts& to) {
  Error error;
  bool is_whole = true;
  const auto need = [&](auto made) {
    if (!made && is_whole) {
      is_whole = false;
      error = made.error();
    }
    return made;
  };
  const Database& database = parts.database;
  const std::vector<std::string> edge_key{"a_experience", "a_place", "b_experience", "b_place", "revision"};
  auto places = need(Scan::make(database, "place", {"experience", "place"}, "revision"));
  auto place_lookup = need(Lookup::make(database));
  auto clear = need(database.prepare("DELETE FROM deleted_places WHERE experience = ?"));
  auto put =
      need(database.prepare("INSERT INTO deleted_places (experience, first_place, last_place) VALUES (?, ?, ?)"));
  auto edges = need(Scan::make(database, "edge", edge_key, "", Scan::Order::down));
  auto edge_lookup = need(Lookup::make(database));
  auto drop_edge = need(
      database.prepare("DELETE FROM edge WHERE a_experience = ? AND a_place = ? AND b_experience = ? AND b_place = ?"
                       " AND revision = ?"));
  auto marks = need(Scan::make(database, "deleted_places", {"experience", "first_place"}, "last_place"));
  auto drop_places = need(database.prepare("DELETE FROM place WHERE experience = ? AND place BETWEEN ? AND ?"));
  auto anew = need(Scan::make(database, "place_anew", {"experience", "place", "revision"}, "", Scan::Order::down));
  auto anew_lookup = need(Lookup::make(database));
  auto drop_anew =
      need(database.prepare("DELETE FROM place_anew WHERE experience = ? AND place = ? AND revision = ?"));
  auto labels = need(Scan::make(database, "label", {"label", "revision"}, "", Scan::Order::down));
  auto drop_label = need(database.prepare("DELETE FROM label WHERE label = ? AND revision = ?"));
  auto rules = need(Scan::make(database, "rule", {"name", "revision"}, "", Scan::Order::down));
  auto drop_rule = need(database.prepare("DELETE FROM rule WHERE name = ? AND revision = ?"));
  auto registrations = need(Scan::make(database, "registration", {"plan", "revision"}, "", Scan::Order::down));
  auto drop_registration = need(database.prepare("DELETE FROM registration WHERE plan = ? AND revision = ?"));
  auto drop_apart = need(database.prepare(
      "DELETE FROM apart WHERE one_experience = ? AND one_first = ? AND one_last = ? AND other_experience = ?"
      " AND other_first = ? AND other_last = ? AND revision = ?"));
  auto drop_moved_places = need(database.prepare(kDropMovedPlaces));
  auto drop_moved_stitches = need(database.prepare(kDropMovedStitches));
  if (!is_whole) return fail(std::move(error));
  to.push_back(
      std::make_unique<MarkPlaces>(std::move(*places), std::move(*place_lookup), std::move(*clear), std::move(*put)));
  to.push_back(std::make_unique<DeleteEdges>(std::move(*edges), std::move(*edge_lookup), std::move(*drop_edge)));
  to.push_back(std::make_unique<DeletePlaces>(std::move(*marks), std::move(*drop_places)));
  to.push_back(std::make_unique<DeletePlacesAnew>(std::move(*anew), std::move(*anew_lookup), std::move(*drop_anew)));
  to.push_back(std::make_unique<DeleteNamed>(DeleteNamed::What::labels, std::move(*labels), std::move(*drop_label)));
  to.push_back(std::make_unique<DeleteNamed>(DeleteNamed::What::rules, std::move(*rules), std::move(*drop_rule)));
  to.push_back(std::make_unique<DeleteNamed>(DeleteNamed::What::registrations, std::move(*registrations),
                                             std::move(*drop_registration)));
  to.push_back(std::make_unique<DeleteAparts>(std::move(*drop_apart)));
  to.push_back(std::make_unique<DeleteMoves>(std::move(*drop_moved_places), std::move(*drop_moved_stitches)));
  return {};
}

}  // namespace weft::storage::sqlite
