#pragma once
#include <optional>
#include <set>
#include <string>

#include "core/result.hpp"
#include "storage/lineage.hpp"
#include "storage/sqlite/row_reading.hpp"

namespace weft::storage::sqlite {

/// Says of which experiences the rows are read.
struct Scope {
  std::optional<std::set<ExperienceId>> only;  ///< none: every experience's
  bool has(ExperienceId id) const { return !only || only->contains(id); }
};

/// Returns the experiences that are not the same in two revisions, which are made of these.
Result<Scope> scope_between(const Database& database, const Lineage& one, const Lineage& other);

/// Visits the rows of a scope's experiences. `select` is "SELECT ... FROM ..." and `order` what follows the
/// condition; `key` is the column of the experience.
template <class Visit>
Result<void> for_each_row_of(const Scope& scope, const Database& database, const std::string& select,
                             const std::string& key, const std::string& order, Visit&& visit) {
  if (!scope.only) return for_each_row(database, select + order, visit);
  for (const ExperienceId id : *scope.only) {
    auto done = for_each_row(database, select + " WHERE " + key + " = ?" + order, visit, id.value);
    if (!done) return done;
  }
  return {};
}

}  // namespace weft::storage::sqlite
