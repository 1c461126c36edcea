#include "clients/cli/commands.hpp"

#include <algorithm>
#include <chrono>

namespace weft::cli {
namespace {
using namespace std::chrono_literals;
using Command = Invocation::Command;

constexpr Duration kReach = 10s;  ///< discovery across vendors takes seconds on a busy machine
}  // namespace

Duration patience(const Invocation& invocation) {
  if (invocation.timeout_s.has_value()) return from_seconds(*invocation.timeout_s);
  switch (invocation.command) {
    case Command::localise:
      return 120s;  // the robot waits for its map and searches it
    case Command::teach_start:
    case Command::teach_stop:
    case Command::map_label:
      return 40s;
    case Command::map_draw:
    case Command::map_export:
    case Command::map_import:
    case Command::map_rollback:
    case Command::map_undo:
    case Command::map_quarantine:
    case Command::map_replace:
    case Command::map_prune:
    case Command::map_compact:
    case Command::map_snapshot:
    case Command::map_check:
    case Command::map_stats:
      return 60s;
    case Command::goal_watch:
      return 24h;
    default:
      return 15s;
  }
}

Exit report(const Error& error, bool json, const Output& output) {
  const Exit exit = exit_of(error);
  output.err << "weft: " << error.message << '\n';
  if (json) {
    const nlohmann::json document = {{"error", {{"code", to_string(error.code)}, {"message", error.message}}},
                                     {"exit", static_cast<int>(exit)}};
    output.out << document.dump(2) << '\n';
  }
  return exit;
}

Names names_of(const std::vector<msg::RobotRow>& robots) {
  Names names;
  for (const msg::RobotRow& row : robots) names[row.description.header.sender] = row.description.name;
  return names;
}

Result<msg::QueryReply> query_robots(Session& session, Duration at_most) {
  msg::Query query;
  query.kind = msg::Query::Kind::robots;
  return session.query(query, at_most);
}

Exit show(const msg::OperatorReply& reply, const Invocation& invocation, const Output& output) {
  const Exit exit = exit_of(reply.outcome);
  if (invocation.json) {
    static constexpr std::array<const char*, 6> kOutcomes = {"",        "done",   "accepted",
                                                             "refused", "failed", "under way"};
    nlohmann::json document = {{"outcome", kOutcomes.at(static_cast<std::size_t>(reply.outcome))},
                               {"message", reply.message}};
    if (reply.goal) document["goal"] = to_string(reply.goal);
    if (reply.place) document["place"] = to_string(reply.place);
    if (reply.experience) document["experience"] = to_string(reply.experience);
    if (reply.revision.value != 0) document["revision"] = reply.revision.value;
    if (!reply.findings.empty()) document["findings"] = reply.findings;
    for (const auto& [name, count] : reply.counts) document["counts"][name] = count;
    output.out << document.dump(2) << '\n';
  }
  if (exit != Exit::done) {
    output.err << "weft: " << reply.message << '\n';
  } else if (!invocation.json) {
    output.out << reply.message << '\n';
  }
  return exit;
}

bool needs_server(Command command) {
  return command != Command::file_info && command != Command::file_convert && command != Command::map_restore;
}

Exit run_offline(const Invocation& invocation, const Output& output) {
  return invocation.command == Command::map_restore ? run_restore(invocation, output) : run_file(invocation, output);
}

Exit run(Session& session, const Invocation& invocation, const Output& output) {
  if (!needs_server(invocation.command)) return run_offline(invocation, output);
  const Result<msg::Hello> server = session.connect(std::min(patience(invocation), kReach));
  if (!server) return report(server.error(), invocation.json, output);
  switch (invocation.command) {
    case Command::robots:
      return run_robots(session, invocation, output);
    case Command::teach_start:
    case Command::teach_stop:
    case Command::localise:
    case Command::stop:
    case Command::resume:
    case Command::robot_clear:
    case Command::map_label:
      return run_operator(session, invocation, output);
    case Command::map_info:
    case Command::map_draw:
    case Command::map_export:
      return run_map(session, invocation, output);
    case Command::map_log:
    case Command::map_diff:
      return run_history(session, invocation, output);
    case Command::map_rollback:
    case Command::map_undo:
    case Command::map_quarantine:
    case Command::map_replace:
    case Command::map_prune:
    case Command::map_compact:
    case Command::map_snapshot:
    case Command::map_check:
    case Command::map_stats:
      return run_map_work(session, invocation, output);
    case Command::map_import:
      return run_import(session, invocation, output);
    case Command::goal_send:
    case Command::goal_list:
    case Command::goal_show:
    case Command::goal_watch:
    case Command::goal_cancel:
    case Command::goal_why:
      return run_goals(session, invocation, output);
    case Command::doctor:
      return run_doctor(session, *server, invocation, output);
    case Command::file_info:
    case Command::file_convert:
    case Command::map_restore:
      break;  // done above
  }
  return report({ErrorCode::internal, "no such command"}, invocation.json, output);
}

}  // namespace weft::cli
