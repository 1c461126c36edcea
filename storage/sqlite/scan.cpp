#include "storage/sqlite/scan.hpp"

namespace weft::storage::sqlite {
namespace {

std::string listed(const std::vector<std::string>& words, const std::string& after_each) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word + after_each;
  return text;
}

}  // namespace

Result<Scan> Scan::make(const Database& database, const std::string& table, const std::vector<std::string>& keys,
                        const std::string& columns, Order order) {
  const std::string key = listed(keys, "");
  const std::string select = "SELECT " + key + (columns.empty() ? "" : ", " + columns) + " FROM " + table;
  const std::string behind = std::string(" WHERE (") + key + (order == Order::up ? ") > (" : ") < (") +
                             listed(std::vector<std::string>(keys.size(), "?"), "") + ")";
  const std::string rest = " ORDER BY " + listed(keys, order == Order::up ? "" : " DESC") + " LIMIT ?";
  auto first = database.prepare(select + rest);
  if (!first) return fail(first.error());
  auto later = database.prepare(select + behind + rest);
  if (!later) return fail(later.error());
  return Scan(std::move(*first), std::move(*later), keys.size());
}

void Scan::remember(const Query& row) {
  last_.resize(keys_);
  for (std::size_t at = 0; at < keys_; ++at) last_[at] = row.value(static_cast<int>(at));
}

}  // namespace weft::storage::sqlite
