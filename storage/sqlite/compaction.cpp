#include "storage/sqlite/compaction.hpp"

#include "storage/sqlite/loader.hpp"
#include "storage/sqlite/row_reading.hpp"

namespace weft::storage::sqlite {

Result<std::unique_ptr<Compaction>> Compaction::make(Parts& parts, Revision floor) {
  const auto bases = load_bases(parts.database);
  if (!bases) return fail(bases.error());
  std::unique_ptr<Compaction> compaction(new Compaction(parts, Retention(floor, *bases)));
  compaction->used_ = std::make_shared<std::set<ContentHash>>();
  parts.used_meanwhile = compaction->used_;
  return compaction;
}

Result<void> Compaction::read_moves() {
  if (moves_read_ == parts_->moves + 1) return {};
  moved_places_.clear();
  moved_stitches_.clear();
  places_of_.reset();
  auto done = for_each_row(
      parts_->database,
      "SELECT revision, is_back, experience, first_place, last_place FROM moved_places ORDER BY revision, is_back",
      [&](const Query& row) {
        moved_places_[{row.number(2)}].push_back({{row.number(0), row.number(1) != 0},
                                                  static_cast<std::uint32_t>(row.number(3)),
                                                  static_cast<std::uint32_t>(row.number(4))});
      });
  if (!done) return done;
  done = for_each_row(
      parts_->database,
      "SELECT revision, is_back, a_experience, a_place, b_experience, b_place FROM moved_stitch"
      " ORDER BY revision, is_back",
      [&](const Query& row) {
        moved_stitches_[{place_id(row, 2), place_id(row, 4)}].push_back({row.number(0), row.number(1) != 0});
      });
  if (done) moves_read_ = parts_->moves + 1;
  return done;
}

Result<const PlaceRetention*> Compaction::places_of(ExperienceId id) {
  if (auto done = read_moves(); !done) return fail(done.error());
  if (!places_of_ || places_of_->first != id) {
    const auto moves = moved_places_.find(id);
    const std::vector<MovedStretch> none;
    places_of_.emplace(id, PlaceRetention(retention_, moves == moved_places_.end() ? none : moves->second));
  }
  return &places_of_->second;
}

Result<const std::vector<Moved>*> Compaction::moves_of(const EdgeId& stitch) {
  static const std::vector<Moved> kNone;
  if (auto done = read_moves(); !done) return fail(done.error());
  const auto moves = moved_stitches_.find(stitch);
  return moves == moved_stitches_.end() ? &kNone : &moves->second;
}

Result<void> Compaction::write(const std::function<Result<void>(StoreRow&)>& work) {
  auto transaction = WriteTransaction::begin(parts_->database);
  if (!transaction) return fail(transaction.error());
  Result<StoreRow> row = current_row(*parts_);
  if (!row) return fail(row.error());
  if (auto done = work(*row); !done) return done;
  if (auto done = write_store_row(parts_->statements, *row); !done) return done;
  if (auto done = transaction->commit(); !done) return done;
  parts_->row = *row;
  return {};
}

}  // namespace weft::storage::sqlite
