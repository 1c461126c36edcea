#pragma once
#include <string>
#include <vector>

#include "core/result.hpp"
#include "storage/sqlite/database.hpp"

namespace weft::storage::sqlite {

/// Reads a table in pieces, in the order of its key, so that others may write between two pieces.
class Scan {
 public:
  enum class Order { up, down };

  /// Prepares a scan. `keys`: the columns of a unique index, in order. `columns`: what else is read, "a, b", or
  /// empty.
  static Result<Scan> make(const Database& database, const std::string& table, const std::vector<std::string>& keys,
                           const std::string& columns, Order order = Order::up);

  /// Calls `visit(const Query&)` for up to `rows` rows behind the last one of the piece before: the columns of the
  /// key first, then the others. True: there may be more. `visit` writes nothing.
  template <class Visit>
  Result<bool> next(std::size_t rows, Visit&& visit) {
    const std::vector<Value> from = last_;  // bound, so it must stay as it is
    Query query(from.empty() ? first_ : later_);
    for (const Value& key : from) query << key;
    query << std::uint64_t{rows};
    std::size_t seen = 0;
    for (;;) {
      const Result<bool> row = query.step();
      if (!row) return fail(row.error());
      if (!*row) return seen == rows;
      ++seen;
      remember(query);
      visit(static_cast<const Query&>(query));
    }
  }

 private:
  Scan(Statement first, Statement later, std::size_t keys)
      : first_(std::move(first)), later_(std::move(later)), keys_(keys) {}
  void remember(const Query& row);

  Statement first_;
  Statement later_;
  std::size_t keys_;
  std::vector<Value> last_;
};

}  // namespace weft::storage::sqlite
