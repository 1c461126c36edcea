#include "clients/cli/run_names.hpp"

#include <algorithm>

namespace weft::cli {

Result<RunNames> query_run_names(Session& session, Duration at_most) {
  msg::Query query;
  query.kind = msg::Query::Kind::experiences;
  const Result<msg::QueryReply> reply = session.query(query, at_most);
  if (!reply) return fail(reply.error());
  RunNames names;
  for (const msg::ExperienceRow& row : reply->experiences) {
    if (!row.name.empty()) names[row.id] = row.name;
  }
  return names;
}

std::string shown_run(ExperienceId run, const RunNames& names) {
  constexpr std::size_t digits = 8;
  const std::string beginning = to_string(run).substr(0, digits);
  const auto found = names.find(run);
  if (found == names.end()) return beginning;
  const auto same = std::ranges::count(names, found->second, [](const auto& entry) { return entry.second; });
  return same == 1 ? found->second : found->second + " (" + beginning + ")";
}

}  // namespace weft::cli
