#include "storage/sqlite/events.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <string_view>

namespace weft::storage::sqlite {
namespace {

constexpr std::string_view kColumns = "at_ns, kind, robot, goal, cause, who, id";

msg::Event event_from_row(const Query& row) {
  msg::Event event;
  event.at = WallTime(Duration(static_cast<std::int64_t>(row.number(0))));
  event.kind = row.text(1);
  event.robot = row.id<RobotId>(2);
  event.goal = row.id<GoalId>(3);
  event.cause = row.text(4);
  event.who = row.text(5);
  event.number = row.number(6);
  return event;
}

/// Returns the statement for a filter. Goal and robot are looked up by their indices, so they stand only where they
/// are asked for.
std::string sql_of(const EventFilter& filter) {
  std::string sql = "SELECT " + std::string(kColumns) + " FROM event WHERE ";
  if (filter.goal) sql += "goal = ? AND ";
  if (filter.robot) sql += "robot = ? AND ";
  sql += "id > ? AND at_ns >= ? AND substr(kind || '.', 1, length(?)) = ?";
  return sql + (goes_forward(filter) ? " ORDER BY id LIMIT ?" : " ORDER BY id DESC LIMIT ?");
}

}  // namespace

Result<EventPage> read_events(const Database& database, const EventFilter& filter, std::size_t limit) {
  const Result<std::uint64_t> oldest = database.number("SELECT coalesce(min(id), 0) FROM event");
  if (!oldest) return fail(oldest.error());
  const Result<std::uint64_t> newest = database.number("SELECT coalesce(max(id), 0) FROM event");
  if (!newest) return fail(newest.error());
  const Result<Statement> statement = database.prepare(sql_of(filter));
  if (!statement) return fail(statement.error());
  const std::string kind = filter.kind.empty() ? std::string() : filter.kind + ".";
  Query query(*statement);
  if (filter.goal) query << filter.goal;
  if (filter.robot) query << filter.robot;
  query << filter.after << static_cast<std::uint64_t>(filter.since.time_since_epoch().count())
        << std::string_view(kind) << std::string_view(kind)
        << std::uint64_t{std::min<std::size_t>(limit, std::numeric_limits<std::int64_t>::max())};
  EventPage page{{}, *oldest, *newest};
  for (;;) {
    const Result<bool> row = query.step();
    if (!row) return fail(row.error());
    if (!*row) break;
    page.events.push_back(event_from_row(query));
  }
  if (!goes_forward(filter)) std::ranges::reverse(page.events);
  return page;
}

}  // namespace weft::storage::sqlite
