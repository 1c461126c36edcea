#include "storage/sqlite/scope.hpp"

namespace weft::storage::sqlite {

Result<Scope> scope_between(const Database& database, const Lineage& one, const Lineage& other) {
  std::set<ExperienceId> differ;
  const auto add = [&](const Query& row) { differ.insert({row.number(0)}); };
  for (const Lineage::Interval& between : one.differing(other)) {
    for (const char* const sql : {"SELECT DISTINCT experience FROM batch WHERE revision BETWEEN ? AND ?",
                                  "SELECT DISTINCT experience FROM place_anew WHERE revision BETWEEN ? AND ?",
                                  "SELECT DISTINCT experience FROM moved_places WHERE revision BETWEEN ? AND ?",
                                  "SELECT DISTINCT a_experience FROM moved_stitch WHERE revision BETWEEN ? AND ?",
                                  "SELECT DISTINCT b_experience FROM moved_stitch WHERE revision BETWEEN ? AND ?"}) {
      auto done = for_each_row(database, sql, add, between.first, between.last);
      if (!done) return fail(done.error());
    }
  }
  return Scope{std::move(differ)};
}

}  // namespace weft::storage::sqlite
