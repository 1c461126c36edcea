#include "storage/sqlite/lookup.hpp"

#include <algorithm>

namespace weft::storage::sqlite {
namespace {

template <class... Bound>
Result<bool> is_there(const Statement& statement, const Bound&... bound) {
  Query query(statement);
  (static_cast<void>(query << bound), ...);
  return query.step();
}

}  // namespace

Result<Lookup> Lookup::make(const Database& database) {
  struct Line {
    Statement Lookup::*slot;
    const char* sql;
  };
  static constexpr Line kLines[] = {
      {&Lookup::place_, "SELECT 1 FROM place WHERE experience = ? AND place = ?"},
      {&Lookup::deleted_,
       "SELECT first_place, last_place FROM deleted_places WHERE experience = ? ORDER BY first_place"},
      {&Lookup::edge_,
       "SELECT 1 FROM edge WHERE a_experience = ? AND a_place = ? AND b_experience = ? AND b_place = ? LIMIT 1"},
      {&Lookup::content_, "SELECT 1 FROM content WHERE hash = ?"},
      {&Lookup::experience_, "SELECT places, durable_through FROM experience WHERE id = ?"},
      {&Lookup::last_place_, "SELECT place FROM place WHERE experience = ? ORDER BY place DESC LIMIT 1"},
      {&Lookup::last_batch_, "SELECT max(sequence) FROM batch WHERE experience = ?"},
  };
  Lookup lookup;
  for (const Line& line : kLines) {
    auto statement = database.prepare(line.sql);
    if (!statement) return fail(statement.error());
    lookup.*line.slot = std::move(*statement);
  }
  return lookup;
}

Result<bool> Lookup::has_place(const PlaceId& id) const {
  return is_there(place_, id.experience.value, std::uint64_t{id.index});
}

Result<const std::vector<Stretch>*> Lookup::deleted_of(ExperienceId id) {
  if (deleted_of_ == id) return &stretches_;
  stretches_.clear();
  deleted_of_.reset();
  Query query(deleted_);
  query << id.value;
  for (;;) {
    const Result<bool> row = query.step();
    if (!row) return fail(row.error());
    if (!*row) break;
    stretches_.push_back(
        {id, static_cast<std::uint32_t>(query.number(0)), static_cast<std::uint32_t>(query.number(1))});
  }
  deleted_of_ = id;
  return &stretches_;
}

Result<bool> Lookup::is_deleted(const PlaceId& id) {
  const auto stretches = deleted_of(id.experience);
  if (!stretches) return fail(stretches.error());
  return std::ranges::any_of(
      **stretches, [&](const Stretch& stretch) { return stretch.first <= id.index && id.index <= stretch.last; });
}

Result<bool> Lookup::has_edge(const EdgeId& id) const {
  return is_there(edge_, id.a.experience.value, std::uint64_t{id.a.index}, id.b.experience.value,
                  std::uint64_t{id.b.index});
}

Result<bool> Lookup::has_content(const ContentHash& hash) const {
  return is_there(content_, hash);
}

Result<std::optional<Lookup::ExperienceRow>> Lookup::experience(ExperienceId id) const {
  Query query(experience_);
  query << id.value;
  const Result<bool> row = query.step();
  if (!row) return fail(row.error());
  if (!*row) return std::optional<ExperienceRow>();
  return std::optional<ExperienceRow>({query.number(0), query.number(1)});
}

Result<std::optional<std::uint64_t>> Lookup::last_place(ExperienceId id) const {
  Query query(last_place_);
  query << id.value;
  const Result<bool> row = query.step();
  if (!row) return fail(row.error());
  return *row ? std::optional<std::uint64_t>(query.number(0)) : std::nullopt;
}

Result<std::uint64_t> Lookup::last_batch(ExperienceId id) const {
  Query query(last_batch_);
  query << id.value;
  const Result<bool> row = query.step();
  if (!row) return fail(row.error());
  return query.number(0);  // none: NULL, which reads as 0
}

}  // namespace weft::storage::sqlite
